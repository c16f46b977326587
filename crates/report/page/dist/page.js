/* built from crates/report/page/src by esbuild: see README.md there */

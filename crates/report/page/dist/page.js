"use strict";(()=>{var jf='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';function X0(n){let e=document.getElementById(`block-${n}`);if(!e)throw new Error(`block ${n} is missing`);return e.textContent??""}function q0(n){let e=Uint8Array;if(e.fromBase64)return e.fromBase64(n);let t=atob(n),i=new Uint8Array(t.length);for(let s=0;s<t.length;s++)i[s]=t.charCodeAt(s);return i}async function vr(n){let e=new Blob([q0(X0(n))]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(e).arrayBuffer()}async function uu(n){let e=new Uint8Array(await vr(n)),t=e.length/4,i=new DataView(new ArrayBuffer(e.length));for(let s=0;s<t;s++)for(let r=0;r<4;r++)i.setUint8(4*s+r,e[r*t+s]);return Float32Array.from({length:t},(s,r)=>i.getFloat32(4*r,!0))}function ba(n){let e=document.getElementById(n);return e?JSON.parse(e.textContent??""):void 0}var Qf=`@media screen { figure.answers > svg { display: none; } }
@media print { .curves { display: none; } }
figure.answers { overflow-x: visible; }
.curves { container-type: inline-size; font-size: 13px; line-height: 1.35; }
.curves .uplot { font: inherit; }
.curves-probe { display: none; }
.curves-bar { position: sticky; z-index: 2; top: 0; background: var(--paper); display: flex; align-items: center; gap: 6px; min-height: 26px; }
.curves-bar output { flex: none; min-width: 8em; font-variant-numeric: tabular-nums; font-weight: 600; }
.curves-hint { flex: 1; overflow: hidden; color: var(--muted); font-size: 12px; text-align: right; text-overflow: ellipsis; white-space: nowrap; opacity: 0; }
.curves:hover .curves-hint, .curves:focus-within .curves-hint { opacity: 1; }
.curves button { color: inherit; font: inherit; cursor: pointer; }
.curves-bar button { flex: none; padding: 1px 8px; border: 1px solid var(--line); border-radius: 4px; background: none; font-size: 12px; }
.curves-bar button:hover:enabled { border-color: var(--muted); }
.curves-bar button:disabled { visibility: hidden; }
.curves button:focus-visible, .curves .u-over:focus-visible { outline: 2px solid #0072b2; outline-offset: 1px; }
.curves-grid { display: grid; grid-template-columns: repeat(var(--abreast), minmax(0, 1fr)); }
.curves-panel { display: flex; flex-direction: column; justify-content: flex-end; min-width: 0; }
.curves-heading[hidden] { display: none; }
.curves-heading { display: flex; flex-wrap: wrap; justify-content: space-between; gap: 0 14px; padding: 4px 10px 0 62px; }
.curves-heading > span, .curves-below { color: var(--muted); font-size: 12px; }
.curves-legend { display: flex; flex-wrap: wrap; padding: 0 10px 0 58px; }
.curves-legend button { display: flex; align-items: center; gap: 5px; padding: 1px 4px; border: 0; border-radius: 4px; background: none; text-align: left; }
.curves-legend button:hover { background: var(--ground); }
.curves-legend button[aria-pressed="false"] { color: var(--muted); text-decoration: line-through; }
.curves-legend button[aria-pressed="false"] svg { opacity: 0.25; }
.curves-legend svg { flex: none; width: 18px; height: 8px; }
.curves-legend path { fill: none; }
.curves-legend data { min-width: 4.6em; font-variant-numeric: tabular-nums; }
.curves-below { display: flex; justify-content: space-between; gap: 14px; padding: 0 10px 0 62px; }
.curves-below span { flex: 1; text-align: right; }
.curves-heading .curves-legend { padding: 0; }
.curves-heading .curves-legend data, .abreast .curves-legend span { display: none; }
.abreast .curves-legend { flex-wrap: nowrap; }
.abreast .curves-legend button { gap: 3px; padding: 1px 2px; font-size: 12px; }
.abreast .curves-legend svg { width: 13px; }
.abreast .curves-heading + .curves-legend data { min-width: 3.2em; }
.curves .u-select { background: color-mix(in srgb, var(--ink) 10%, transparent); }
@container (max-width: 560px) {
  .curves-hint { visibility: hidden; }
  .curves-heading, .curves-below { padding-left: 8px; }
  .curves-legend { padding-left: 4px; }
  .curves-grid { grid-template-columns: minmax(0, 1fr); }
}
`;function Sa(n,e){return document.documentElement.lang.startsWith("zh")?e:n}var li=Sa({time:"time",csv:"Save the numbers of this figure as CSV",png:"Save this figure as PNG",whole:"whole length",wholeHint:"Show the whole length again",hint:"drag: enlarge · double-click: whole length · name: off and on",line:n=>`${n}: off and on; with Shift alone`,axes:n=>`${n}. Left and right move the cursor, plus and minus enlarge and reduce, Escape shows all.`,thinned:(n,e)=>`Shown are ${n} of ${e} rows: in every stretch of the history those in which a curve is largest or smallest.`},{time:"时间",csv:"将本图数据存为 CSV",png:"将本图存为 PNG",whole:"全程",wholeHint:"恢复显示全程",hint:"拖动放大 · 双击复原 · 点名称开关曲线",line:n=>`${n}：点击开关，按住 Shift 只看此线`,axes:n=>`${n}。左右键移动光标，加减键缩放，Esc 键复原。`,thinned:(n,e)=>`显示 ${e} 行中的 ${n} 行：各时段内任一曲线取最大值或最小值的行。`});function br(n,e){return e?`${n} (${e})`:n}function Bs(n){return n.across.name||li.time}function ed(n,e){for(let t=0;t<n.length;t++){if(e-t>=0&&n[e-t]!==void 0)return e-t;if(e+t<n.length&&n[e+t]!==void 0)return e+t}return e}async function td(n){let[e,t]=await Promise.all([uu(n.across_block),uu(n.block)]),i=0,s=()=>{let r=t.subarray(i*n.rows,++i*n.rows);return Array.from(r,o=>Number.isNaN(o)?null:Number.isFinite(o)?o:void 0)};return{across:Array.from(e),panels:n.panels.map(r=>r.lines.map(s))}}function hu(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(e),t.download=n,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function nd(n,e){let t=e?`${n} [${e}]`:n;return/[",\n]/.test(t)?`"${t.replaceAll('"','""')}"`:t}function id(n){return n==null?"":String(Number(n.toPrecision(7)))}function sd(n,{across:e,panels:t}){let i=n.panels.length>1,s=n.panels.flatMap(a=>a.lines.map(l=>nd(i&&l.name?`${a.title}: ${l.name}`:l.name||a.title,a.unit))),r=t.flat(),o=e.map((a,l)=>[id(a),...r.map(c=>id(c[l]))].join(","));return[[nd(Bs(n),n.across.unit),...s].join(","),...o,""].join(`
`)}function yo(n,e=4){if(n==null)return"–";if(n===0)return"0";let t=Math.abs(n),i=n<0?"−":"";if(t>=1e6||t<1e-4)return i+rd(t,e);let s=Math.max(0,e-1-Math.floor(Math.log10(t)));return i+t.toFixed(s)}function rd(n,e){let[t,i]=n.toExponential(e-1).split("e");return`${t} × 10${$0(Number(i))}`}function $0(n){let e=[...String(Math.abs(n))].map(t=>"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(t)]).join("");return(n<0?"⁻":"")+e}function fu(n,e){let t=n.filter(a=>a!=null),i=t.length>1?Math.min(...t.slice(1).map((a,l)=>Math.abs(a-t[l]))):Math.abs(t[0]??1),s=Z0(i||1),r=e&&t.some(a=>a<99e-5||a>101e3),o=a=>{if(a===0)return"0";let l=Math.abs(a),c=a<0?"−":"";return l!==1&&(r||l>=1e6||l<1e-4)?c+rd(l,2).replace(/\.0(?= )/,"").replace(/^1 × /,""):c+(e?String(Number(l.toPrecision(6))):l.toFixed(s))};return n.map(a=>a==null?"":o(a))}function Z0(n){for(let t=0;t<12;t++){let i=n*10**t;if(i>.99&&Math.abs(i-Math.round(i))<1e-6*i)return t}return 12}var od={s0:"#0072B2",s1:"#D55E00",s2:"#009E73",s3:"#333333",s4:"#CC79A7",s5:"#E69F00",s6:"#56B4E9",ink:"#1f2933",muted:"#5b6773",grid:"#e2e6ea",axis:"#8b95a1",paper:"#ffffff"},Ma=class{onPaper=!1;known=new Map;probe=document.createElementNS("http://www.w3.org/2000/svg","svg");constructor(){this.probe.setAttribute("class","curves-probe");for(let[e,t]of Object.entries(od)){let i=document.createElementNS(this.probe.namespaceURI,"path");i.setAttribute("class",e),i.setAttribute("stroke",t),i.setAttribute("fill",t),this.probe.append(i)}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.known.clear())}of(e,t){let i=`${e} ${t} ${this.onPaper}`,s=this.known.get(i);if(s===void 0){let r=this.probe.querySelector(`.${e}`);s=this.onPaper||!r?.isConnected?od[e]:getComputedStyle(r)[t],(r?.isConnected||this.onPaper)&&this.known.set(i,s)}return s}line=e=>this.of(`s${e%7}`,"stroke");ink=()=>this.of("ink","fill");muted=()=>this.of("muted","fill");grid=()=>this.of("grid","stroke");axis=()=>this.of("axis","stroke");paper=()=>this.of("paper","fill")};function Sr(n,e){let t=n==="broad"?4.2:1.4;return n==="dashed"||e>=7?{width:t,dash:[6,3]}:{width:t}}var wa=class{constructor(e,t,i){this.lines=e;this.element.className="curves-legend",this.element.setAttribute("role","group"),this.buttons=e.map((s,r)=>this.entry(s,t(s),r,i)),this.element.append(...this.buttons),this.element.addEventListener("keydown",s=>this.moved(s))}lines;element=document.createElement("div");buttons;values=[];entry(e,t,i,s){let r=document.createElement("button");r.type="button",r.title=li.line(e.name),r.tabIndex=i===0?0:-1;let o=document.createElement("data"),a=document.createElement("span");a.textContent=e.name,r.append(K0(e,t),a,o),this.values.push(o),r.addEventListener("click",l=>s.toggled(e.name,l.shiftKey));for(let l of["pointerenter","focus"])r.addEventListener(l,()=>s.lifted(e.name));for(let l of["pointerleave","blur"])r.addEventListener(l,()=>s.lifted(null));return r}moved(e){let t={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[e.key],i=this.buttons.indexOf(document.activeElement);if(!t||i<0)return;e.preventDefault();let s=this.buttons[(i+t+this.buttons.length)%this.buttons.length];for(let r of this.buttons)r.tabIndex=r===s?0:-1;s.focus()}show(e){this.lines.forEach((t,i)=>this.buttons[i].setAttribute("aria-pressed",String(!e.has(t.name))))}at(e,t){this.values.forEach((i,s)=>{let{value:r,elsewhere:o}=e?.[s]??{};i.textContent=e?yo(r,t)+(o?` (${o})`:""):"",i.value=r==null?"":String(Number(r.toPrecision(7)))})}};function K0(n,e){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox","0 0 18 8"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(t,"path"),{width:r,dash:o}=Sr(n.stroke,n.colour);return s.setAttribute("class",`s${n.colour%7}`),s.setAttribute("stroke",e),s.setAttribute("stroke-width",String(Math.max(r,2.4))),o&&s.setAttribute("stroke-dasharray",o.join(" ")),s.setAttribute("d","M0 4h18"),i.append(s),i}var J0="uplot",j0="u-hz",Q0="u-vt",e_="u-title",t_="u-wrap",n_="u-under",i_="u-over",s_="u-axis",Vs="u-off",r_="u-select",o_="u-cursor-x",a_="u-cursor-y",l_="u-cursor-pt",c_="u-legend",u_="u-live",h_="u-inline",f_="u-series",d_="u-marker",ad="u-label",p_="u-value",bo="width",So="height";var ld="bottom",Mr="left",du="right",Pu="#000",cd=Pu+"0",pu="mousemove",ud="mousedown",mu="mouseup",hd="mouseenter",fd="mouseleave",dd="dblclick",m_="resize",g_="scroll",pd="change",Ra="dppxchange",Iu="--",Pr=typeof window<"u",vu=Pr?document:null,Er=Pr?window:null,__=Pr?navigator:null,Ct,Ea;function bu(){let n=devicePixelRatio;Ct!=n&&(Ct=n,Ea&&Mu(pd,Ea,bu),Ea=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Gs(pd,Ea,bu),Er.dispatchEvent(new CustomEvent(Ra)))}function Yn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Su(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Ht(n,e,t){n.style[e]=t+"px"}function xi(n,e,t,i){let s=vu.createElement(n);return e!=null&&Yn(s,e),t?.insertBefore(s,i),s}function ci(n,e){return xi("div",n,e)}var md=new WeakMap;function Oi(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=md.get(n);r!=o&&(n.style.transform=r,md.set(n,r),e<0||t<0||e>i||t>s?Yn(n,Vs):Su(n,Vs))}var gd=new WeakMap;function _d(n,e,t){let i=e+t,s=gd.get(n);i!=s&&(gd.set(n,i),n.style.background=e,n.style.borderColor=t)}var xd=new WeakMap;function yd(n,e,t,i){let s=e+""+t,r=xd.get(n);s!=r&&(xd.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Lu={passive:!0},x_={...Lu,capture:!0};function Gs(n,e,t,i){e.addEventListener(n,t,i?x_:Lu)}function Mu(n,e,t,i){e.removeEventListener(n,t,Lu)}Pr&&bu();function yi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:$n((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Yd(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var $d=n=>n!=null,Zd=n=>n!=null&&n>0,La=Yd($d),y_=Yd(Zd);function v_(n,e,t,i=0,s=!1){let r=s?y_:La,o=s?Zd:$d;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ot,l??-Ot]}function Da(n,e,t,i){let s=Sd(n),r=Sd(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Zi:Kd,a=s==1?$n:ui,l=r==1?ui:$n,c=a(o(dn(n))),u=l(o(dn(e))),h=Ar(t,c),f=Ar(t,u);return t==10&&(c<0&&(h=Bt(h,-c)),u<0&&(f=Bt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=ep(n,h),e=Na(e,f)),[n,e]}function Du(n,e,t,i){let s=Da(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Nu=.1,vd={mode:3,pad:Nu},wo={pad:0,soft:null,mode:0},b_={min:wo,max:wo};function Pa(n,e,t,i){return Ua(t)?bd(n,e,t):(wo.pad=t,wo.soft=i?0:null,wo.mode=i?3:0,bd(n,e,b_))}function At(n,e){return n??e}function S_(n,e,t){for(e=At(e,0),t=At(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function bd(n,e,t){let i=t.min,s=t.max,r=At(i.pad,0),o=At(s.pad,0),a=At(i.hard,-Ot),l=At(s.hard,Ot),c=At(i.soft,Ot),u=At(s.soft,-Ot),h=At(i.mode,0),f=At(s.mode,0),d=e-n,m=Zi(d),y=Fn(dn(n),dn(e)),p=Zi(y),g=dn(p-m);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Ot&&(r=0),f==2&&u!=-Ot&&(o=0)));let v=d||y||1e3,T=Zi(v),S=Ar(10,$n(T)),C=v*(d==0?n==0?.1:1:r),A=Bt(ep(n-C,S/10),24),x=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Ot,E=Fn(a,A<x&&n>=x?x:vi(x,A)),z=v*(d==0?e==0?.1:1:o),U=Bt(Na(e+z,S/10),24),D=e<=u&&(f==1||f==3&&U>=u||f==2&&U<=u)?u:-Ot,H=vi(l,U>D&&e<=D?D:Fn(D,U));return E==H&&E==0&&(H=100),[E,H]}var M_=new Intl.NumberFormat(Pr?__.language:"en-US"),Uu=n=>M_.format(n),Zn=Math,Ca=Zn.PI,dn=Zn.abs,$n=Zn.floor,fn=Zn.round,ui=Zn.ceil,vi=Zn.min,Fn=Zn.max,Ar=Zn.pow,Sd=Zn.sign,Zi=Zn.log10,Kd=Zn.log2,w_=(n,e=1)=>Zn.sinh(n)*e,gu=(n,e=1)=>Zn.asinh(n/e),Ot=1/0;function Md(n){return(Zi((n^n>>31)-(n>>31))|0)+1}function wu(n,e,t){return vi(Fn(n,e),t)}function Jd(n){return typeof n=="function"}function bt(n){return Jd(n)?n:()=>n}var E_=()=>{},jd=n=>n,Qd=(n,e)=>e,A_=n=>null,wd=n=>!0,Ed=(n,e)=>n==e,T_=/\.\d*?(?=9{6,}|0{6,})/gm,Hs=n=>{if(np(n)||_s.has(n))return n;let e=`${n}`,t=e.match(T_);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Hs(s)}e${r}`}return Bt(n,i)};function ks(n,e){return Hs(Bt(Hs(n/e))*e)}function Na(n,e){return Hs(ui(Hs(n/e))*e)}function ep(n,e){return Hs($n(Hs(n/e))*e)}function Bt(n,e=0){if(np(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return fn(i)/t}var _s=new Map;function tp(n){return((""+n).split(".")[1]||"").length}function Ao(n,e,t,i){let s=[],r=i.map(tp);for(let o=e;o<t;o++){let a=dn(o),l=Bt(Ar(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Bt(u,h);s.push(f),_s.set(f,h)}}return s}var Eo={},Fu=[],Tr=[null,null],gs=Array.isArray,np=Number.isInteger,C_=n=>n===void 0;function Ad(n){return typeof n=="string"}function Ua(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function R_(n){return n!=null&&typeof n=="object"}var P_=Object.getPrototypeOf(Uint8Array),ip="__proto__";function Cr(n,e=Ua){let t;if(gs(n)){let i=n.find(s=>s!=null);if(gs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Cr(n[s],e)}else t=n.slice()}else if(n instanceof P_)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ip&&(t[i]=Cr(n[i],e))}else t=n;return t}function cn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=ip&&(Ua(n[s])?cn(n[s],Cr(i[s])):n[s]=Cr(i[s]))}return n}var I_=0,L_=1,D_=2;function N_(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function U_(n,e){if(B_(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return k_(o[0])||(o=O_(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:L_,d=[];for(let m=0;m<u.length;m++){let y=u[m],p=r.get(l[m]);y===null?f!=I_&&(h[p]=y,f==D_&&d.push(p)):h[p]=y}N_(h,d,s),i.push(h)}}return i}var F_=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function O_(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function B_(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function k_(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Fn(1,$n((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var sp=["January","February","March","April","May","June","July","August","September","October","November","December"],rp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function op(n){return n.slice(0,3)}var z_=rp.map(op),V_=sp.map(op),G_={MMMM:sp,MMM:V_,WWWW:rp,WWW:z_};function vo(n){return(n<10?"0":"")+n}function H_(n){return(n<10?"00":n<100?"0":"")+n}var W_={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>vo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>vo(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>vo(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>vo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>vo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>H_(n.getMilliseconds())};function Ou(n,e){e=e||G_;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?W_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var X_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function q_(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==X_?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var ap=n=>n%1==0,Ia=[1,2,2.5,5],Y_=Ao(10,-32,0,Ia),lp=Ao(10,0,32,Ia),$_=lp.filter(ap),zs=Y_.concat(lp),Bu=`
`,cp="{YYYY}",Td=Bu+cp,up="{M}/{D}",Mo=Bu+up,Aa=Mo+"/{YY}",hp="{aa}",Z_="{h}:{mm}",wr=Z_+hp,Cd=Bu+wr,Rd=":{ss}",Pt=null;function fp(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ao(10,0,3,Ia).filter(ap):Ao(10,-3,0,Ia)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,cp,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Td,Pt,Pt,Pt,Pt,Pt,1],[s,up,Td,Pt,Pt,Pt,Pt,Pt,1],[i,"{h}"+hp,Aa,Pt,Mo,Pt,Pt,Pt,1],[t,wr,Aa,Pt,Mo,Pt,Pt,Pt,1],[e,Rd,Aa+" "+wr,Pt,Mo+" "+wr,Pt,Cd,Pt,1],[n,Rd+".{fff}",Aa+" "+wr,Pt,Mo+" "+wr,Pt,Cd,Pt,1]];function u(h){return(f,d,m,y,p,g)=>{let v=[],T=p>=o,S=p>=r&&p<o,C=h(m),A=Bt(C*n,3),x=_u(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),E=Bt(x*n,3);if(S||T){let z=S?p/r:0,U=T?p/o:0,D=A==E?A:Bt(_u(x.getFullYear()+U,x.getMonth()+z,1)*n,3),H=new Date(fn(D/n)),O=H.getFullYear(),I=H.getMonth();for(let V=0;D<=y;V++){let Y=_u(O+U*V,I+z*V,1),k=Y-h(Bt(Y*n,3));D=Bt((+Y+k)*n,3),D<=y&&v.push(D)}}else{let z=p>=s?s:p,U=$n(m)-$n(A),D=E+U+Na(A-E,z);v.push(D);let H=h(D),O=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,I=p/i,V=f.axes[d]._space,Y=g/V;for(;D=Bt(D+p,n==1?0:3),!(D>y);)if(I>1){let k=$n(Bt(O+I,6))%24,J=h(D).getHours()-k;J>1&&(J=-1),D-=J*i,O=(O+I)%24;let ne=v[v.length-1];Bt((D-ne)/p,3)*Y>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,u]}var[K_,J_,j_]=fp(1),[Q_,ex,tx]=fp(.001);Ao(2,-53,53,[1]);function Pd(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Id(n,e){return(t,i,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,d;return i.map(m=>{let y=n(m),p=y.getFullYear(),g=y.getMonth(),v=y.getDate(),T=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),A=p!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||S!=f&&a[6]||C!=d&&a[7]||a[1];return l=p,c=g,u=v,h=T,f=S,d=C,A(y)})}}function nx(n,e){let t=Ou(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function _u(n,e,t){return new Date(n,e,t)}function Ld(n,e){return e(n)}var ix="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Dd(n,e){return(t,i,s,r)=>r==null?Iu:e(n(i))}function sx(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function rx(n,e){return n.series[e].fill(n,e)}var ox={show:!0,live:!0,isolate:!1,mount:E_,markers:{show:!0,width:2,stroke:sx,fill:rx,dash:"solid"},idx:null,idxs:null,values:[]};function ax(n,e){let t=n.cursor.points,i=ci(),s=t.size(n,e);Ht(i,bo,s),Ht(i,So,s);let r=s/-2;Ht(i,"marginLeft",r),Ht(i,"marginTop",r);let o=t.width(n,e,s);return o&&Ht(i,"borderWidth",o),i}function lx(n,e){let t=n.series[e].points;return t._fill||t._stroke}function cx(n,e){let t=n.series[e].points;return t._stroke||t._fill}function ux(n,e){return n.series[e].points.size}var xu=[0,0];function hx(n,e,t){return xu[0]=e,xu[1]=t,xu}function Ta(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function yu(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var fx={show:!0,x:!0,y:!0,lock:!1,move:hx,points:{one:!1,show:ax,size:ux,width:0,stroke:cx,fill:lx},bind:{mousedown:Ta,mouseup:Ta,click:Ta,dblclick:Ta,mousemove:yu,mouseleave:yu,mouseenter:yu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},dp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ku=cn({},dp,{filter:Qd}),pp=cn({},ku,{size:10}),mp=cn({},dp,{show:!1}),zu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',gp="bold "+zu,_p=1.5,Nd={show:!0,scale:"x",stroke:Pu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gp,side:2,grid:ku,ticks:pp,border:mp,font:zu,lineGap:_p,rotate:0},dx="Value",px="Time",Ud={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function mx(n,e,t,i,s){return e.map(r=>r==null?"":Uu(r))}function gx(n,e,t,i,s,r,o){let a=[],l=_s.get(s)||0;t=o?t:Bt(Na(t,s),l);for(let c=t;c<=i;c=Bt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Eu(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Zi:Kd,u=$n(c(t));s=Ar(l,u),l==10&&(s=zs[yi(s,zs)]);let h=t,f=s*l;l==10&&(f=zs[yi(f,zs)]);do a.push(h),h=h+s,l==10&&!_s.has(h)&&(h=Bt(h,_s.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=zs[yi(f,zs)]));while(h<=i);return a}function _x(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Eu(n,e,Fn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Eu(n,e,Fn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var xp=/./,xx=/[12357]/,yx=/[125]/,Fd=/1/,Au=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function vx(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?xp:l(7,o)-u>=c?xx:l(5,o)-u>=c?yx:Fd;if(h==Fd){let f=dn(l(1,o)-u);if(f<c)return Au(e.slice().reverse(),a.distr,h,ui(c/f)).reverse()}return Au(e,a.distr,h,1)}function bx(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=dn(l(1,o)-l(2,o));return c<a?Au(e.slice().reverse(),3,xp,ui(a/c)).reverse():e}function Sx(n,e,t,i){return i==null?Iu:e==null?"":Uu(e)}var Od={show:!0,scale:"y",stroke:Pu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:gp,side:3,grid:ku,ticks:pp,border:mp,font:zu,lineGap:_p,rotate:0};function Mx(n,e){let t=3+(n||1)*2;return Bt(t*e,3)}function wx(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=dn(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var Bd={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},yp=(n,e,t,i,s)=>s,kd={show:!0,auto:!0,sorted:0,gaps:yp,alpha:1,facets:[cn({},Bd,{scale:"x"}),cn({},Bd,{scale:"y"})]},zd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:yp,alpha:1,points:{show:wx,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function Ex(n,e,t,i,s){return t/10}var vp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Ax=cn({},vp,{time:!1,ori:1}),Vd={};function bp(n,e){let t=Vd[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Vd[n]=t)),t}var Rr=1,Tu=2;function Ws(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,m=a.width,y=a.height,p=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,h,p,g,f,d,m,y,Oa,Ir,ka,Mp,Ep):t(s,l,c,u,h,g,p,d,f,y,m,Ba,Lr,Hu,wp,Ap)}function Vu(n,e){let t=0,i=0,s=At(n.bands,Fu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Tx(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ki(n,e,t,i,s,r){return Ws(n,e,(o,a,l,c,u,h,f,d,m,y,p)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?Ir:Lr,S,C;v==1?(S=t,C=i):(S=i,C=t);let A=g(h(a[S],c,y,d)),x=g(f(l[S],u,p,m)),E=g(h(a[C],c,y,d)),z=g(f(r==1?u.max:u.min,u,p,m)),U=new Path2D(s);return T(U,E,z),T(U,A,z),T(U,A,x),U})}function Fa(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ka:Hu,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Cx(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Gu(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),m=f==h?d:r(n[f]),y=h-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let g=f+s;m=o>=0&&g>=0&&g<l?r(n[g]):m,m>=d&&a.push([d,m])}return a}function Gd(n){return n==0?jd:n==1?fn:e=>ks(e,n)}function Sp(n){let e=n==0?Oa:Ba,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=vi(c,a/2,l/2),u=vi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Oa=(n,e,t)=>{n.moveTo(e,t)},Ba=(n,e,t)=>{n.moveTo(t,e)},Ir=(n,e,t)=>{n.lineTo(e,t)},Lr=(n,e,t)=>{n.lineTo(t,e)},ka=Sp(0),Hu=Sp(1),Mp=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},wp=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Ep=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Ap=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Tp(n){return(e,t,i,s,r)=>Ws(e,t,(o,a,l,c,u,h,f,d,m,y,p)=>{let{pxRound:g,points:v}=o,T,S;c.ori==0?(T=Oa,S=Mp):(T=Ba,S=wp);let C=Bt(v.width*Ct,3),A=(v.size-v.width)/2*Ct,x=Bt(A*2,3),E=new Path2D,z=new Path2D,{left:U,top:D,width:H,height:O}=e.bbox;ka(z,U-x,D-x,H+x*2,O+x*2);let I=V=>{if(l[V]!=null){let Y=g(h(a[V],c,y,d)),k=g(f(l[V],u,p,m));T(E,Y+A,k),S(E,Y,k,A,0,Ca*2)}};if(r)r.forEach(I);else for(let V=i;V<=s;V++)I(V);return{stroke:C>0?E:null,fill:E,clip:z,flags:Rr|Tu}})}function Cp(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Rx=Cp(Ir),Px=Cp(Lr);function Rp(n){let e=At(n?.alignGaps,0);return(t,i,s,r)=>Ws(t,i,(o,a,l,c,u,h,f,d,m,y,p)=>{[s,r]=La(l,s,r);let g=o.pxRound,v=O=>g(h(O,c,y,d)),T=O=>g(f(O,u,p,m)),S,C;c.ori==0?(S=Ir,C=Rx):(S=Lr,C=Px);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Rr},E=x.stroke,z=!1;if(r-s>=y*4){let O=ce=>t.posToVal(ce,c.key,!0),I=null,V=null,Y,k,ae,$=v(a[A==1?s:r]),J=v(a[s]),ne=v(a[r]),he=O(A==1?J+1:ne-1);for(let ce=A==1?s:r;ce>=s&&ce<=r;ce+=A){let j=a[ce],ge=(A==1?j<he:j>he)?$:v(j),_e=l[ce];ge==$?_e!=null?(k=_e,I==null?(S(E,ge,T(k)),Y=I=V=k):k<I?I=k:k>V&&(V=k)):_e===null&&(z=!0):(I!=null&&C(E,$,T(I),T(V),T(Y),T(k)),_e!=null?(k=_e,S(E,ge,T(k)),I=V=Y=k):(I=V=null,_e===null&&(z=!0)),$=ge,he=O($+A))}I!=null&&I!=V&&ae!=$&&C(E,$,T(I),T(V),T(Y),T(k))}else for(let O=A==1?s:r;O>=s&&O<=r;O+=A){let I=l[O];I===null?z=!0:I!=null&&S(E,v(a[O]),T(I))}let[D,H]=Vu(t,i);if(o.fill!=null||D!=0){let O=x.fill=new Path2D(E),I=o.fillTo(t,i,o.min,o.max,D),V=T(I),Y=v(a[s]),k=v(a[r]);A==-1&&([k,Y]=[Y,k]),S(O,k,V),S(O,Y,V)}if(!o.spanGaps){let O=[];z&&O.push(...Gu(a,l,s,r,A,v,e)),x.gaps=O=o.gaps(t,i,s,r,O),x.clip=Fa(O,c.ori,d,m,y,p)}return H!=0&&(x.band=H==2?[Ki(t,i,s,r,E,-1),Ki(t,i,s,r,E,1)]:Ki(t,i,s,r,E,H)),x})}function Ix(n){let e=At(n.align,1),t=At(n.ascDesc,!1),i=At(n.alignGaps,0),s=At(n.extend,!1);return(r,o,a,l)=>Ws(r,o,(c,u,h,f,d,m,y,p,g,v,T)=>{[a,l]=La(h,a,l);let S=c.pxRound,{left:C,width:A}=r.bbox,x=J=>S(m(J,f,v,p)),E=J=>S(y(J,d,T,g)),z=f.ori==0?Ir:Lr,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Rr},D=U.stroke,H=f.dir*(f.ori==0?1:-1),O=E(h[H==1?a:l]),I=x(u[H==1?a:l]),V=I,Y=I;s&&e==-1&&(Y=C,z(D,Y,O)),z(D,I,O);for(let J=H==1?a:l;J>=a&&J<=l;J+=H){let ne=h[J];if(ne==null)continue;let he=x(u[J]),ce=E(ne);e==1?z(D,he,O):z(D,V,ce),z(D,he,ce),O=ce,V=he}let k=V;s&&e==1&&(k=C+A,z(D,k,O));let[ae,$]=Vu(r,o);if(c.fill!=null||ae!=0){let J=U.fill=new Path2D(D),ne=c.fillTo(r,o,c.min,c.max,ae),he=E(ne);z(J,k,he),z(J,Y,he)}if(!c.spanGaps){let J=[];J.push(...Gu(u,h,a,l,H,x,i));let ne=c.width*Ct/2,he=t||e==1?ne:-ne,ce=t||e==-1?-ne:ne;J.forEach(j=>{j[0]+=he,j[1]+=ce}),U.gaps=J=c.gaps(r,o,a,l,J),U.clip=Fa(J,f.ori,p,g,v,T)}return $!=0&&(U.band=$==2?[Ki(r,o,a,l,D,-1),Ki(r,o,a,l,D,1)]:Ki(r,o,a,l,D,$)),U})}function Hd(n,e,t,i,s,r,o=Ot){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=dn(n[l]-n[a]);u<c&&(c=u,o=dn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Lx(n){n=n||Eo;let e=At(n.size,[.6,Ot,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=At(e[1],Ot),l=At(e[2],1),c=At(n.disp,Eo),u=At(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,y,p)=>Ws(d,m,(g,v,T,S,C,A,x,E,z,U,D)=>{let H=g.pxRound,O=t,I=i*Ct,V=a*Ct,Y=l*Ct,k,ae;S.ori==0?[k,ae]=r(d,m):[ae,k]=r(d,m);let $=S.dir*(S.ori==0?1:-1),J=S.ori==0?ka:Hu,ne=S.ori==0?u:(Me,$e,rt,Ae,Ft,Xe,Ze)=>{u(Me,$e,rt,Ft,Ae,Ze,Xe)},he=At(d.bands,Fu).find(Me=>Me.series[0]==m),ce=he!=null?he.dir:0,j=g.fillTo(d,m,g.min,g.max,ce),pe=H(x(j,C,D,z)),ge,_e,Se,ke=U,st=H(g.width*Ct),We=!1,fe=null,Le=null,Ee=null,Qe=null;h!=null&&(st==0||f!=null)&&(We=!0,fe=h.values(d,m,y,p),Le=new Map,new Set(fe).forEach(Me=>{Me!=null&&Le.set(Me,new Path2D)}),st>0&&(Ee=f.values(d,m,y,p),Qe=new Map,new Set(Ee).forEach(Me=>{Me!=null&&Qe.set(Me,new Path2D)})));let{x0:mt,size:wt}=c;if(mt!=null&&wt!=null){O=1,v=mt.values(d,m,y,p),mt.unit==2&&(v=v.map(rt=>d.posToVal(E+rt*U,S.key,!0)));let Me=wt.values(d,m,y,p);wt.unit==2?_e=Me[0]*U:_e=A(Me[0],S,U,E)-A(0,S,U,E),ke=Hd(v,T,A,S,U,E,ke),Se=ke-_e+I}else ke=Hd(v,T,A,S,U,E,ke),Se=ke*o+I,_e=ke-Se;Se<1&&(Se=0),st>=_e/2&&(st=0),Se<5&&(H=jd);let ct=Se>0,Xt=ke-Se-(ct?st:0);_e=H(wu(Xt,Y,V)),ge=(O==0?_e/2:O==$?0:_e)-O*$*((O==0?I/2:0)+(ct?st/2:0));let ut={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Jt=We?null:new Path2D,qt=null;if(he!=null)qt=d.data[he.series[1]];else{let{y0:Me,y1:$e}=c;Me!=null&&$e!=null&&(T=$e.values(d,m,y,p),qt=Me.values(d,m,y,p))}let Mt=k*_e,N=ae*_e;for(let Me=$==1?y:p;Me>=y&&Me<=p;Me+=$){let $e=T[Me];if($e==null)continue;if(qt!=null){let X=qt[Me]??0;if($e-X==0)continue;pe=x(X,C,D,z)}let rt=S.distr!=2||c!=null?v[Me]:Me,Ae=A(rt,S,U,E),Ft=x(At($e,j),C,D,z),Xe=H(Ae-ge),Ze=H(Fn(Ft,pe)),R=H(vi(Ft,pe)),b=Ze-R;if($e!=null){let X=$e<0?N:Mt,ue=$e<0?Mt:N;We?(st>0&&Ee[Me]!=null&&J(Qe.get(Ee[Me]),Xe,R+$n(st/2),_e,Fn(0,b-st),X,ue),fe[Me]!=null&&J(Le.get(fe[Me]),Xe,R+$n(st/2),_e,Fn(0,b-st),X,ue)):J(Jt,Xe,R+$n(st/2),_e,Fn(0,b-st),X,ue),ne(d,m,Me,Xe-st/2,R,_e+st,b)}}return st>0?ut.stroke=We?Qe:Jt:We||(ut._fill=g.width==0?g._fill:g._stroke??g._fill,ut.width=0),ut.fill=We?Le:Jt,ut})}function Dx(n,e){let t=At(e?.alignGaps,0);return(i,s,r,o)=>Ws(i,s,(a,l,c,u,h,f,d,m,y,p,g)=>{[r,o]=La(c,r,o);let v=a.pxRound,T=k=>v(f(k,u,p,m)),S=k=>v(d(k,h,g,y)),C,A,x;u.ori==0?(C=Oa,x=Ir,A=Ep):(C=Ba,x=Lr,A=Ap);let E=u.dir*(u.ori==0?1:-1),z=T(l[E==1?r:o]),U=z,D=[],H=[];for(let k=E==1?r:o;k>=r&&k<=o;k+=E)if(c[k]!=null){let $=l[k],J=T($);D.push(U=J),H.push(S(c[k]))}let O={stroke:n(D,H,C,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:Rr},I=O.stroke,[V,Y]=Vu(i,s);if(a.fill!=null||V!=0){let k=O.fill=new Path2D(I),ae=a.fillTo(i,s,a.min,a.max,V),$=S(ae);x(k,U,$),x(k,z,$)}if(!a.spanGaps){let k=[];k.push(...Gu(l,c,r,o,E,T,t)),O.gaps=k=a.gaps(i,s,r,o,k),O.clip=Fa(k,u.ori,m,y,p,g)}return Y!=0&&(O.band=Y==2?[Ki(i,s,r,o,I,-1),Ki(i,s,r,o,I,1)]:Ki(i,s,r,o,I,Y)),O})}function Nx(n){return Dx(Ux,n)}function Ux(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var Cu=new Set;function Wd(){for(let n of Cu)n.syncRect(!0)}Pr&&(Gs(m_,Er,Wd),Gs(g_,Er,Wd,!0),Gs(Ra,Er,()=>{wn.pxRatio=Ct}));var Fx=Rp(),Ox=Tp();function Xd(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Ru(r,o,e,t))}function Bx(n,e){return n.map((t,i)=>i==0?{}:cn({},e,t))}function Ru(n,e,t,i){return cn({},e==0?t:i,n)}function Pp(n,e,t){return e==null?Tr:[e,t]}var kx=Pp;function zx(n,e,t){return e==null?Tr:Pa(e,t,Nu,!0)}function Ip(n,e,t,i){return e==null?Tr:Da(e,t,n.scales[i].log,!1)}var Vx=Ip;function Lp(n,e,t,i){return e==null?Tr:Du(e,t,n.scales[i].log,!1)}var Gx=Lp;function Hx(n,e,t,i,s){let r=Fn(Md(n),Md(e)),o=e-n,a=yi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?_s.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function qd(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=fn((t=+s)*Ct))+"px"),[n,e,t]}function Wx(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Bt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(n,e,t){let i={mode:At(n.mode,1)},s=i.mode;function r(_,M,P,L){let G=M.valToPct(_);return L+P*(M.dir==-1?1-G:G)}function o(_,M,P,L){let G=M.valToPct(_);return L+P*(M.dir==-1?G:1-G)}function a(_,M,P,L){return M.ori==0?r(_,M,P,L):o(_,M,P,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ci(J0);if(n.id!=null&&(c.id=n.id),Yn(c,n.class),n.title){let _=ci(e_,c);_.textContent=n.title}let u=xi("canvas"),h=i.ctx=u.getContext("2d"),f=ci(t_,c);Gs("click",f,_=>{_.target===m&&(zt!=mr||Yt!=gr)&&Mn.click(i,_)},!0);let d=i.under=ci(n_,f);f.appendChild(u);let m=i.over=ci(i_,f);n=Cr(n);let y=+At(n.pxAlign,1),p=Gd(y);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?Xd(n.series||[],Ud,zd,!1):Bx(n.series||[null],kd),T=i.axes=Xd(n.axes||[],Nd,Od,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=bt(_.fill||null),_.dir=At(_.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,x={axes:Yi,series:_t},E=(n.drawOrder||["axes","series"]).map(_=>x[_]);function z(_){let M=_.distr==3?P=>Zi(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>gu(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let L=M(P),{_min:G,_max:K}=_,oe=K-G;return(L-G)/oe}}function U(_){let M=S[_];if(M==null){let P=(n.scales||Eo)[_]||Eo;if(P.from!=null){U(P.from);let L=cn({},S[P.from],P,{key:_});L.valToPct=z(L),S[_]=L}else{M=S[_]=cn({},_==A?vp:Ax,P),M.key=_;let L=M.time,G=M.range,K=gs(G);if((_!=A||s==2&&!L)&&(K&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?vd:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?vd:{mode:1,hard:G[1],soft:G[1]}},K=!1),!K&&Ua(G))){let oe=G;G=(de,be,Fe)=>be==null?Tr:Pa(be,Fe,oe)}M.range=bt(G||(L?kx:_==A?M.distr==3?Vx:M.distr==4?Gx:Pp:M.distr==3?Ip:M.distr==4?Lp:zx)),M.auto=bt(K?!1:M.auto),M.clamp=bt(M.clamp||Ex),M._min=M._max=null,M.valToPct=z(M)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),T.forEach(_=>{U(_.scale)});for(let _ in n.scales)U(_);let D=S[A],H=D.distr,O,I;D.ori==0?(Yn(c,j0),O=r,I=o):(Yn(c,Q0),O=o,I=r);let V={};for(let _ in S){let M=S[_];(M.min!=null||M.max!=null)&&(V[_]={min:M.min,max:M.max},M.min=M.max=null)}let Y=n.tzDate||(_=>new Date(fn(_/g))),k=n.fmtDate||Ou,ae=g==1?j_(Y):tx(Y),$=Id(Y,Pd(g==1?J_:ex,k)),J=Dd(Y,Ld(ix,k)),ne=[],he=i.legend=cn({},ox,n.legend),ce=i.cursor=cn({},fx,{drag:{y:s==2}},n.cursor),j=he.show,pe=ce.show,ge=he.markers;he.idxs=ne,ge.width=bt(ge.width),ge.dash=bt(ge.dash),ge.stroke=bt(ge.stroke),ge.fill=bt(ge.fill);let _e,Se,ke,st=[],We=[],fe,Le=!1,Ee={};if(he.live){let _=v[1]?v[1].values:null;Le=_!=null,fe=Le?_(i,1,0):{_:0};for(let M in fe)Ee[M]=Iu}if(j)if(_e=xi("table",c_,c),ke=xi("tbody",null,_e),he.mount(i,_e),Le){Se=xi("thead",null,_e,ke);let _=xi("tr",null,Se);xi("th",null,_);for(var Qe in fe)xi("th",ad,_).textContent=Qe}else Yn(_e,h_),he.live&&Yn(_e,u_);let mt={show:!0},wt={show:!1};function ct(_,M){if(M==0&&(Le||!he.live||s==2))return Tr;let P=[],L=xi("tr",f_,ke,ke.childNodes[M]);Yn(L,_.class),_.show||Yn(L,Vs);let G=xi("th",null,L);if(ge.show){let de=ci(d_,G);if(M>0){let be=ge.width(i,M);be&&(de.style.border=be+"px "+ge.dash(i,M)+" "+ge.stroke(i,M)),de.style.background=ge.fill(i,M)}}let K=ci(ad,G);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,M>0&&(ge.show||(K.style.color=_.width>0?ge.stroke(i,M):ge.fill(i,M)),ut("click",G,de=>{if(ce._lock)return;et(de);let be=v.indexOf(_);if((de.ctrlKey||de.metaKey)!=he.isolate){let Fe=v.some((Oe,ze)=>ze>0&&ze!=be&&Oe.show);v.forEach((Oe,ze)=>{ze>0&&Di(ze,Fe?ze==be?mt:wt:mt,!0,ln.setSeries)})}else Di(be,{show:!_.show},!0,ln.setSeries)},!1),tt&&ut(hd,G,de=>{ce._lock||(et(de),Di(v.indexOf(_),xr,!0,ln.setSeries))},!1));for(var oe in fe){let de=xi("td",p_,L);de.textContent="--",P.push(de)}return[L,P]}let Xt=new Map;function ut(_,M,P,L=!0){let G=Xt.get(M)||{},K=ce.bind[_](i,M,P,L);K&&(Gs(_,M,G[_]=K),Xt.set(M,G))}function Jt(_,M,P){let L=Xt.get(M)||{};for(let G in L)(_==null||G==_)&&(Mu(G,M,L[G]),delete L[G]);_==null&&Xt.delete(M)}let qt=0,Mt=0,N=0,Me=0,$e=0,rt=0,Ae=$e,Ft=rt,Xe=N,Ze=Me,R=0,b=0,X=0,ue=0;i.bbox={};let re=!1,ye=!1,ve=!1,ee=!1,ie=!1,me=!1;function F(_,M,P){(P||_!=i.width||M!=i.height)&&se(_,M),dt(!1),ve=!0,ye=!0,An()}function se(_,M){i.width=qt=N=_,i.height=Mt=Me=M,$e=rt=0,we(),qe();let P=i.bbox;R=P.left=ks($e*Ct,.5),b=P.top=ks(rt*Ct,.5),X=P.width=ks(N*Ct,.5),ue=P.height=ks(Me*Ct,.5)}let te=3;function Te(){let _=!1,M=0;for(;!_;){M++;let P=fr(M),L=Li(M);_=M==te||P&&L,_||(se(i.width,i.height),ye=!0)}}function xe({width:_,height:M}){F(_,M)}i.setSize=xe;function we(){let _=!1,M=!1,P=!1,L=!1;T.forEach((G,K)=>{if(G.show&&G._show){let{side:oe,_size:de}=G,be=oe%2,Fe=G.label!=null?G.labelSize:0,Oe=de+Fe;Oe>0&&(be?(N-=Oe,oe==3?($e+=Oe,L=!0):P=!0):(Me-=Oe,oe==0?(rt+=Oe,_=!0):M=!0))}}),Pi[0]=_,Pi[1]=P,Pi[2]=M,Pi[3]=L,N-=mi[1]+mi[3],$e+=mi[3],Me-=mi[2]+mi[0],rt+=mi[0]}function qe(){let _=$e+N,M=rt+Me,P=$e,L=rt;function G(K,oe){switch(K){case 1:return _+=oe,_-oe;case 2:return M+=oe,M-oe;case 3:return P-=oe,P+oe;case 0:return L-=oe,L+oe}}T.forEach((K,oe)=>{if(K.show&&K._show){let de=K.side;K._pos=G(de,K._size),K.label!=null&&(K._lpos=G(de,K.labelSize))}})}if(ce.dataIdx==null){let _=ce.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let P=_.prox=bt(_.prox),L=_.bias??=0;ce.dataIdx=(G,K,oe,de)=>{if(K==0)return oe;let be=oe,Fe=P(G,K,oe,de)??Ot,Oe=Fe>=0&&Fe<Ot,ze=D.ori==0?N:Me,at=ce.left,Tt=e[0],Et=e[K];if(M.has(Et[oe])){be=null;let yt=null,je=null,Ye;if(L==0||L==-1)for(Ye=oe;yt==null&&Ye-- >0;)M.has(Et[Ye])||(yt=Ye);if(L==0||L==1)for(Ye=oe;je==null&&Ye++<Et.length;)M.has(Et[Ye])||(je=Ye);if(yt!=null||je!=null)if(Oe){let Gt=yt==null?-1/0:O(Tt[yt],D,ze,0),en=je==null?1/0:O(Tt[je],D,ze,0),vn=at-Gt,Ut=en-at;vn<=Ut?vn<=Fe&&(be=yt):Ut<=Fe&&(be=je)}else be=je==null?yt:yt==null?je:oe-yt<=je-oe?yt:je}else Oe&&dn(at-O(Tt[oe],D,ze,0))>Fe&&(be=null);return be}}let et=_=>{ce.event=_};ce.idxs=ne,ce._lock=!1;let le=ce.points;le.show=bt(le.show),le.size=bt(le.size),le.stroke=bt(le.stroke),le.width=bt(le.width),le.fill=bt(le.fill);let Ve=i.focus=cn({},n.focus||{alpha:.3},ce.focus),tt=Ve.prox>=0,Ie=tt&&le.one,ft=[],kt=[],In=[];function uo(_,M){let P=le.show(i,M);if(P instanceof HTMLElement)return Yn(P,l_),Yn(P,_.class),Oi(P,-10,-10,N,Me),m.insertBefore(P,ft[M]),P}function cr(_,M){if(s==1||M>0){let P=s==1&&S[_.scale].time,L=_.value;_.value=P?Ad(L)?Dd(Y,Ld(L,k)):L||J:L||Sx,_.label=_.label||(P?px:dx)}if(Ie||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Fx||A_,_.fillTo=bt(_.fillTo||Tx),_.pxAlign=+At(_.pxAlign,y),_.pxRound=Gd(_.pxAlign),_.stroke=bt(_.stroke||null),_.fill=bt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=Mx(Fn(1,_.width),1),L=_.points=cn({},{size:P,width:Fn(1,P*.2),stroke:_.stroke,space:P*2,paths:Ox,_stroke:null,_fill:null},_.points);L.show=bt(L.show),L.filter=bt(L.filter),L.fill=bt(L.fill),L.stroke=bt(L.stroke),L.paths=bt(L.paths),L.pxAlign=_.pxAlign}if(j){let P=ct(_,M);st.splice(M,0,P[0]),We.splice(M,0,P[1]),he.values.push(null)}if(pe){ne.splice(M,0,null);let P=null;Ie?M==0&&(P=uo(_,M)):M>0&&(P=uo(_,M)),ft.splice(M,0,P),kt.splice(M,0,0),In.splice(M,0,0)}yn("addSeries",M)}function eu(_,M){M=M??v.length,_=s==1?Ru(_,M,Ud,zd):Ru(_,M,{},kd),v.splice(M,0,_),cr(v[M],M)}i.addSeries=eu;function _a(_){if(v.splice(_,1),j){he.values.splice(_,1),We.splice(_,1);let M=st.splice(_,1)[0];Jt(null,M.firstChild),M.remove()}pe&&(ne.splice(_,1),ft.splice(_,1)[0].remove(),kt.splice(_,1),In.splice(_,1)),yn("delSeries",_)}i.delSeries=_a;let Pi=[!1,!1,!1,!1];function Wi(_,M){if(_._show=_.show,_.show){let P=_.side%2,L=S[_.scale];L==null&&(_.scale=P?v[1].scale:A,L=S[_.scale]);let G=L.time;_.size=bt(_.size),_.space=bt(_.space),_.rotate=bt(_.rotate),gs(_.incrs)&&_.incrs.forEach(oe=>{!_s.has(oe)&&_s.set(oe,tp(oe))}),_.incrs=bt(_.incrs||(L.distr==2?$_:G?g==1?K_:Q_:zs)),_.splits=bt(_.splits||(G&&L.distr==1?ae:L.distr==3?Eu:L.distr==4?_x:gx)),_.stroke=bt(_.stroke),_.grid.stroke=bt(_.grid.stroke),_.ticks.stroke=bt(_.ticks.stroke),_.border.stroke=bt(_.border.stroke);let K=_.values;_.values=gs(K)&&!gs(K[0])?bt(K):G?gs(K)?Id(Y,Pd(K,k)):Ad(K)?nx(Y,K):K||$:K||mx,_.filter=bt(_.filter||(L.distr>=3&&L.log==10?vx:L.distr==3&&L.log==2?bx:Qd)),_.font=qd(_.font),_.labelFont=qd(_.labelFont),_._size=_.size(i,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Pi[M]=!0,_._el=ci(s_,f))}}function Xi(_,M,P,L){let[G,K,oe,de]=P,be=M%2,Fe=0;return be==0&&(de||K)&&(Fe=M==0&&!G||M==2&&!oe?fn(Nd.size/3):0),be==1&&(G||oe)&&(Fe=M==1&&!K||M==3&&!de?fn(Od.size/2):0),Fe}let ho=i.padding=(n.padding||[Xi,Xi,Xi,Xi]).map(_=>bt(At(_,Xi))),mi=i._padding=ho.map((_,M)=>_(i,M,Pi,0)),jt,nn=null,sn=null,Ii=s==1?v[0].idxs:null,Hn=null,us=!1;function fo(_,M){if(e=_??[],i.data=i._data=e,s==2){jt=0;for(let P=1;P<v.length;P++)jt+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Hn=e[0],jt=Hn.length;let P=e;if(H==2){P=e.slice();let L=P[0]=Array(jt);for(let G=0;G<jt;G++)L[G]=G}i._data=e=P}if(dt(!0),yn("setData"),H==2&&(ve=!0),M!==!1){let P=D;P.auto(i,us)?po():ds(A,P.min,P.max),ee=ee||ce.left>=0,me=!0,An()}}i.setData=fo;function po(){us=!0;let _,M;s==1&&(jt>0?(nn=Ii[0]=0,sn=Ii[1]=jt-1,_=e[0][nn],M=e[0][sn],H==2?(_=nn,M=sn):_==M&&(H==3?[_,M]=Da(_,_,D.log,!1):H==4?[_,M]=Du(_,_,D.log,!1):D.time?M=_+fn(86400/g):[_,M]=Pa(_,M,Nu,!0))):(nn=Ii[0]=_=null,sn=Ii[1]=M=null)),ds(A,_,M)}let ur,hs,hr,w,B,Q,q,Z,Ce,De;function Re(_,M,P,L,G,K){_??=cd,P??=Fu,L??="butt",G??=cd,K??="round",_!=ur&&(h.strokeStyle=ur=_),G!=hs&&(h.fillStyle=hs=G),M!=hr&&(h.lineWidth=hr=M),K!=B&&(h.lineJoin=B=K),L!=Q&&(h.lineCap=Q=L),P!=w&&h.setLineDash(w=P)}function Ne(_,M,P,L){M!=hs&&(h.fillStyle=hs=M),_!=q&&(h.font=q=_),P!=Z&&(h.textAlign=Z=P),L!=Ce&&(h.textBaseline=Ce=L)}function He(_,M,P,L,G=0){if(L.length>0&&_.auto(i,us)&&(M==null||M.min==null)){let K=At(nn,0),oe=At(sn,L.length-1),de=P.min==null?v_(L,K,oe,G,_.distr==3):[P.min,P.max];_.min=vi(_.min,P.min=de[0]),_.max=Fn(_.max,P.max=de[1])}}let nt={min:null,max:null};function gt(){for(let L in S){let G=S[L];V[L]==null&&(G.min==null||V[A]!=null&&G.auto(i,us))&&(V[L]=nt)}for(let L in S){let G=S[L];V[L]==null&&G.from!=null&&V[G.from]!=null&&(V[L]=nt)}V[A]!=null&&dt(!0);let _={};for(let L in V){let G=V[L];if(G!=null){let K=_[L]=Cr(S[L],R_);if(G.min!=null)cn(K,G);else if(L!=A||s==2)if(jt==0&&K.from==null){let oe=K.range(i,null,null,L);K.min=oe[0],K.max=oe[1]}else K.min=Ot,K.max=-Ot}}if(jt>0){v.forEach((L,G)=>{if(s==1){let K=L.scale,oe=V[K];if(oe==null)return;let de=_[K];if(G==0){let be=de.range(i,de.min,de.max,K);de.min=be[0],de.max=be[1],nn=yi(de.min,e[0]),sn=yi(de.max,e[0]),sn-nn>1&&(e[0][nn]<de.min&&nn++,e[0][sn]>de.max&&sn--),L.min=Hn[nn],L.max=Hn[sn]}else L.show&&L.auto&&He(de,oe,L,e[G],L.sorted);L.idxs[0]=nn,L.idxs[1]=sn}else if(G>0&&L.show&&L.auto){let[K,oe]=L.facets,de=K.scale,be=oe.scale,[Fe,Oe]=e[G],ze=_[de],at=_[be];ze!=null&&He(ze,V[de],K,Fe,K.sorted),at!=null&&He(at,V[be],oe,Oe,oe.sorted),L.min=oe.min,L.max=oe.max}});for(let L in _){let G=_[L],K=V[L];if(G.from==null&&(K==null||K.min==null)){let oe=G.range(i,G.min==Ot?null:G.min,G.max==-Ot?null:G.max,L);G.min=oe[0],G.max=oe[1]}}}for(let L in _){let G=_[L];if(G.from!=null){let K=_[G.from];if(K.min==null)G.min=G.max=null;else{let oe=G.range(i,K.min,K.max,L);G.min=oe[0],G.max=oe[1]}}}let M={},P=!1;for(let L in _){let G=_[L],K=S[L];if(K.min!=G.min||K.max!=G.max){K.min=G.min,K.max=G.max;let oe=K.distr;K._min=oe==3?Zi(K.min):oe==4?gu(K.min,K.asinh):oe==100?K.fwd(K.min):K.min,K._max=oe==3?Zi(K.max):oe==4?gu(K.max,K.asinh):oe==100?K.fwd(K.max):K.max,M[L]=P=!0}}if(P){v.forEach((L,G)=>{s==2?G>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)ve=!0,yn("setScale",L);pe&&ce.left>=0&&(ee=me=!0)}for(let L in V)V[L]=null}function Ge(_){let M=wu(nn-1,0,jt-1),P=wu(sn+1,0,jt-1);for(;_[M]==null&&M>0;)M--;for(;_[P]==null&&P<jt-1;)P++;return[M,P]}function _t(){if(jt>0){let _=v.some(M=>M._focus)&&De!=Ve.alpha;_&&(h.globalAlpha=De=Ve.alpha),v.forEach((M,P)=>{if(P>0&&M.show&&($t(P,!1),$t(P,!0),M._paths==null)){let L=De;De!=M.alpha&&(h.globalAlpha=De=M.alpha);let G=s==2?[0,e[P][0].length-1]:Ge(e[P]);M._paths=M.paths(i,P,G[0],G[1]),De!=L&&(h.globalAlpha=De=L)}}),v.forEach((M,P)=>{if(P>0&&M.show){let L=De;De!=M.alpha&&(h.globalAlpha=De=M.alpha),M._paths!=null&&Lt(P,!1);{let G=M._paths!=null?M._paths.gaps:null,K=M.points.show(i,P,nn,sn,G),oe=M.points.filter(i,P,K,G);(K||oe)&&(M.points._paths=M.points.paths(i,P,nn,sn,oe),Lt(P,!0))}De!=L&&(h.globalAlpha=De=L),yn("drawSeries",P)}}),_&&(h.globalAlpha=De=1)}}function $t(_,M){let P=M?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Lt(_,M){let P=M?v[_].points:v[_],{stroke:L,fill:G,clip:K,flags:oe,_stroke:de=P._stroke,_fill:be=P._fill,_width:Fe=P.width}=P._paths;Fe=Bt(Fe*Ct,3);let Oe=null,ze=Fe%2/2;M&&be==null&&(be=Fe>0?"#fff":de);let at=P.pxAlign==1&&ze>0;if(at&&h.translate(ze,ze),!M){let Tt=R-Fe/2,Et=b-Fe/2,yt=X+Fe,je=ue+Fe;Oe=new Path2D,Oe.rect(Tt,Et,yt,je)}M?Be(de,Fe,P.dash,P.cap,be,L,G,oe,K):Dt(_,de,Fe,P.dash,P.cap,be,L,G,oe,Oe,K),at&&h.translate(-ze,-ze)}function Dt(_,M,P,L,G,K,oe,de,be,Fe,Oe){let ze=!1;be!=0&&C.forEach((at,Tt)=>{if(at.series[0]==_){let Et=v[at.series[1]],yt=e[at.series[1]],je=(Et._paths||Eo).band;gs(je)&&(je=at.dir==1?je[0]:je[1]);let Ye,Gt=null;Et.show&&je&&S_(yt,nn,sn)?(Gt=at.fill(i,Tt)||K,Ye=Et._paths.clip):je=null,Be(M,P,L,G,Gt,oe,de,be,Fe,Oe,Ye,je),ze=!0}}),ze||Be(M,P,L,G,K,oe,de,be,Fe,Oe)}let hn=Rr|Tu;function Be(_,M,P,L,G,K,oe,de,be,Fe,Oe,ze){Re(_,M,P,L,G),(be||Fe||ze)&&(h.save(),be&&h.clip(be),Fe&&h.clip(Fe)),ze?(de&hn)==hn?(h.clip(ze),Oe&&h.clip(Oe),vt(G,oe),rn(_,K,M)):de&Tu?(vt(G,oe),h.clip(ze),rn(_,K,M)):de&Rr&&(h.save(),h.clip(ze),Oe&&h.clip(Oe),vt(G,oe),h.restore(),rn(_,K,M)):(vt(G,oe),rn(_,K,M)),(be||Fe||ze)&&h.restore()}function rn(_,M,P){P>0&&(M instanceof Map?M.forEach((L,G)=>{h.strokeStyle=ur=G,h.stroke(L)}):M!=null&&_&&h.stroke(M))}function vt(_,M){M instanceof Map?M.forEach((P,L)=>{h.fillStyle=hs=L,h.fill(P)}):M!=null&&_&&h.fill(M)}function qi(_,M,P,L){let G=T[_],K;if(L<=0)K=[0,0];else{let oe=G._space=G.space(i,_,M,P,L),de=G._incrs=G.incrs(i,_,M,P,L,oe);K=Hx(M,P,de,L,oe)}return G._found=K}function on(_,M,P,L,G,K,oe,de,be,Fe){let Oe=oe%2/2;y==1&&h.translate(Oe,Oe),Re(de,oe,be,Fe,de),h.beginPath();let ze,at,Tt,Et,yt=G+(L==0||L==3?-K:K);P==0?(at=G,Et=yt):(ze=G,Tt=yt);for(let je=0;je<_.length;je++)M[je]!=null&&(P==0?ze=Tt=_[je]:at=Et=_[je],h.moveTo(ze,at),h.lineTo(Tt,Et));h.stroke(),y==1&&h.translate(-Oe,-Oe)}function fr(_){let M=!0;return T.forEach((P,L)=>{if(!P.show)return;let G=S[P.scale];if(G.min==null){P._show&&(M=!1,P._show=!1,dt(!1));return}else P._show||(M=!1,P._show=!0,dt(!1));let K=P.side,oe=K%2,{min:de,max:be}=G,[Fe,Oe]=qi(L,de,be,oe==0?N:Me);if(Oe==0)return;let ze=G.distr==2,at=P._splits=P.splits(i,L,de,be,Fe,Oe,ze),Tt=G.distr==2?at.map(Ye=>Hn[Ye]):at,Et=G.distr==2?Hn[at[1]]-Hn[at[0]]:Fe,yt=P._values=P.values(i,P.filter(i,Tt,L,Oe,Et),L,Oe,Et);P._rotate=K==2?P.rotate(i,yt,L,Oe):0;let je=P._size;P._size=ui(P.size(i,yt,L,_)),je!=null&&P._size!=je&&(M=!1)}),M}function Li(_){let M=!0;return ho.forEach((P,L)=>{let G=P(i,L,Pi,_);G!=mi[L]&&(M=!1),mi[L]=G}),M}function Yi(){for(let _=0;_<T.length;_++){let M=T[_];if(!M.show||!M._show)continue;let P=M.side,L=P%2,G,K,oe=M.stroke(i,_),de=P==0||P==3?-1:1,[be,Fe]=M._found;if(M.label!=null){let Nn=M.labelGap*de,qn=fn((M._lpos+Nn)*Ct);Ne(M.labelFont[0],oe,"center",P==2?"top":ld),h.save(),L==1?(G=K=0,h.translate(qn,fn(b+ue/2)),h.rotate((P==3?-Ca:Ca)/2)):(G=fn(R+X/2),K=qn);let Os=Jd(M.label)?M.label(i,_,be,Fe):M.label;h.fillText(Os,G,K),h.restore()}if(Fe==0)continue;let Oe=S[M.scale],ze=L==0?X:ue,at=L==0?R:b,Tt=M._splits,Et=Oe.distr==2?Tt.map(Nn=>Hn[Nn]):Tt,yt=Oe.distr==2?Hn[Tt[1]]-Hn[Tt[0]]:be,je=M.ticks,Ye=M.border,Gt=je.show?je.size:0,en=fn(Gt*Ct),vn=fn((M.alignTo==2?M._size-Gt-M.gap:M.gap)*Ct),Ut=M._rotate*-Ca/180,tn=p(M._pos*Ct),Wn=(en+vn)*de,Dn=tn+Wn;K=L==0?Dn:0,G=L==1?Dn:0;let oi=M.font[0],gi=M.align==1?Mr:M.align==2?du:Ut>0?Mr:Ut<0?du:L==0?"center":P==3?du:Mr,Ui=Ut||L==1?"middle":P==2?"top":ld;Ne(oi,oe,gi,Ui);let Xn=M.font[1]*M.lineGap,ai=Tt.map(Nn=>p(a(Nn,Oe,ze,at))),_i=M._values;for(let Nn=0;Nn<_i.length;Nn++){let qn=_i[Nn];if(qn!=null){L==0?G=ai[Nn]:K=ai[Nn],qn=""+qn;let Os=qn.indexOf(`
`)==-1?[qn]:qn.split(/\n/gm);for(let Un=0;Un<Os.length;Un++){let Jf=Os[Un];Ut?(h.save(),h.translate(G,K+Un*Xn),h.rotate(Ut),h.fillText(Jf,0,0),h.restore()):h.fillText(Jf,G,K+Un*Xn)}}}je.show&&on(ai,je.filter(i,Et,_,Fe,yt),L,P,tn,en,Bt(je.width*Ct,3),je.stroke(i,_),je.dash,je.cap);let Fi=M.grid;Fi.show&&on(ai,Fi.filter(i,Et,_,Fe,yt),L,L==0?2:1,L==0?b:R,L==0?ue:X,Bt(Fi.width*Ct,3),Fi.stroke(i,_),Fi.dash,Fi.cap),Ye.show&&on([tn],[1],L==0?1:0,L==0?1:2,L==1?b:R,L==1?ue:X,Bt(Ye.width*Ct,3),Ye.stroke(i,_),Ye.dash,Ye.cap)}yn("drawAxes")}function dt(_){v.forEach((M,P)=>{P>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let Qt=!1,Ln=!1,Nt=[];function an(){Ln=!1;for(let _=0;_<Nt.length;_++)yn(...Nt[_]);Nt.length=0}function An(){Qt||(F_(Df),Qt=!0)}function xa(_,M=!1){Qt=!0,Ln=M,_(i),Df(),M&&Nt.length>0&&queueMicrotask(an)}i.batch=xa;function Df(){if(re&&(gt(),re=!1),ve&&(Te(),ve=!1),ye){if(Ht(d,Mr,$e),Ht(d,"top",rt),Ht(d,bo,N),Ht(d,So,Me),Ht(m,Mr,$e),Ht(m,"top",rt),Ht(m,bo,N),Ht(m,So,Me),Ht(f,bo,qt),Ht(f,So,Mt),u.width=fn(qt*Ct),u.height=fn(Mt*Ct),T.forEach(({_el:_,_show:M,_size:P,_pos:L,side:G})=>{if(_!=null)if(M){let K=G===3||G===0?P:0,oe=G%2==1;Ht(_,oe?"left":"top",L-K),Ht(_,oe?"width":"height",P),Ht(_,oe?"top":"left",oe?rt:$e),Ht(_,oe?"height":"width",oe?Me:N),Su(_,Vs)}else Yn(_,Vs)}),ur=hs=hr=B=Q=q=Z=Ce=w=null,De=1,_o(!0),$e!=Ae||rt!=Ft||N!=Xe||Me!=Ze){dt(!1);let _=N/Xe,M=Me/Ze;if(pe&&!ee&&ce.left>=0){ce.left*=_,ce.top*=M,dr&&Oi(dr,fn(ce.left),0,N,Me),pr&&Oi(pr,0,fn(ce.top),N,Me);for(let P=0;P<ft.length;P++){let L=ft[P];L!=null&&(kt[P]*=_,In[P]*=M,Oi(L,ui(kt[P]),ui(In[P]),N,Me))}}if(Vt.show&&!ie&&Vt.left>=0&&Vt.width>0){Vt.left*=_,Vt.width*=_,Vt.top*=M,Vt.height*=M;for(let P in ou)Ht(_r,P,Vt[P])}Ae=$e,Ft=rt,Xe=N,Ze=Me}yn("setSize"),ye=!1}qt>0&&Mt>0&&(h.clearRect(0,0,u.width,u.height),yn("drawClear"),E.forEach(_=>_()),yn("draw")),Vt.show&&ie&&(ya(Vt),ie=!1),pe&&ee&&(Fs(null,!0,!1),ee=!1),he.show&&he.live&&me&&(su(),me=!1),l||(l=!0,i.status=1,yn("ready")),us=!1,Qt=!1}i.redraw=(_,M)=>{ve=M||!1,_!==!1?ds(A,D.min,D.max):An()};function tu(_,M){let P=S[_];if(P.from==null){if(jt==0){let L=P.range(i,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(jt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&P.distr==2&&jt>0&&(M.min=yi(M.min,e[0]),M.max=yi(M.max,e[0]),M.min==M.max&&M.max++),V[_]=M,re=!0,An()}}i.setScale=tu;let nu,iu,dr,pr,Nf,Uf,mr,gr,Ff,Of,zt,Yt,fs=!1,Mn=ce.drag,_n=Mn.x,xn=Mn.y;pe&&(ce.x&&(nu=ci(o_,m)),ce.y&&(iu=ci(a_,m)),D.ori==0?(dr=nu,pr=iu):(dr=iu,pr=nu),zt=ce.left,Yt=ce.top);let Vt=i.select=cn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),_r=Vt.show?ci(r_,Vt.over?m:d):null;function ya(_,M){if(Vt.show){for(let P in _)Vt[P]=_[P],P in ou&&Ht(_r,P,_[P]);M!==!1&&yn("setSelect")}}i.setSelect=ya;function L0(_){if(v[_].show)j&&Su(st[_],Vs);else if(j&&Yn(st[_],Vs),pe){let P=Ie?ft[0]:ft[_];P!=null&&Oi(P,-10,-10,N,Me)}}function ds(_,M,P){tu(_,{min:M,max:P})}function Di(_,M,P,L){M.focus!=null&&O0(_),M.show!=null&&v.forEach((G,K)=>{K>0&&(_==K||_==null)&&(G.show=M.show,L0(K),s==2?(ds(G.facets[0].scale,null,null),ds(G.facets[1].scale,null,null)):ds(G.scale,null,null),An())}),P!==!1&&yn("setSeries",_,M),L&&xo("setSeries",i,_,M)}i.setSeries=Di;function D0(_,M){cn(C[_],M)}function N0(_,M){_.fill=bt(_.fill||null),_.dir=At(_.dir,-1),M=M??C.length,C.splice(M,0,_)}function U0(_){_==null?C.length=0:C.splice(_,1)}i.addBand=N0,i.setBand=D0,i.delBand=U0;function F0(_,M){v[_].alpha=M,pe&&ft[_]!=null&&(ft[_].style.opacity=M),j&&st[_]&&(st[_].style.opacity=M)}let $i,ps,Us,xr={focus:!0};function O0(_){if(_!=Us){let M=_==null,P=Ve.alpha!=1;v.forEach((L,G)=>{if(s==1||G>0){let K=M||G==0||G==_;L._focus=M?null:K,P&&F0(G,K?1:Ve.alpha)}}),Us=_,P&&An()}}j&&tt&&ut(fd,_e,_=>{ce._lock||(et(_),Us!=null&&Di(null,xr,!0,ln.setSeries))});function Ni(_,M,P){let L=S[M];P&&(_=_/Ct-(L.ori==1?rt:$e));let G=N;L.ori==1&&(G=Me,_=G-_),L.dir==-1&&(_=G-_);let K=L._min,oe=L._max,de=_/G,be=K+(oe-K)*de,Fe=L.distr;return Fe==3?Ar(10,be):Fe==4?w_(be,L.asinh):Fe==100?L.bwd(be):be}function B0(_,M){let P=Ni(_,A,M);return yi(P,e[0],nn,sn)}i.valToIdx=_=>yi(_,e[0]),i.posToIdx=B0,i.posToVal=Ni,i.valToPos=(_,M,P)=>S[M].ori==0?r(_,S[M],P?X:N,P?R:0):o(_,S[M],P?ue:Me,P?b:0),i.setCursor=(_,M,P)=>{zt=_.left,Yt=_.top,Fs(null,M,P)};function Bf(_,M){Ht(_r,Mr,Vt.left=_),Ht(_r,bo,Vt.width=M)}function kf(_,M){Ht(_r,"top",Vt.top=_),Ht(_r,So,Vt.height=M)}let mo=D.ori==0?Bf:kf,go=D.ori==1?Bf:kf;function k0(){if(j&&he.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&Le)continue;let M=he.values[_],P=0;for(let L in M)We[_][P++].firstChild.nodeValue=M[L]}}function su(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((P,L)=>{ne[L]=P}):C_(_.idx)||ne.fill(_.idx),he.idx=ne[0]),j&&he.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!Le)&&z0(P,ne[P]);k0()}me=!1,M!==!1&&yn("setLegend")}i.setLegend=su;function z0(_,M){let P=v[_],L=_==0&&H==2?Hn:e[_],G;Le?G=P.values(i,_,M)??Ee:(G=P.value(i,M==null?null:L[M],_,M),G=G==null?Ee:{_:G}),he.values[_]=G}function Fs(_,M,P){Ff=zt,Of=Yt,[zt,Yt]=ce.move(i,zt,Yt),ce.left=zt,ce.top=Yt,pe&&(dr&&Oi(dr,fn(zt),0,N,Me),pr&&Oi(pr,0,fn(Yt),N,Me));let L,G=nn>sn;$i=Ot,ps=null;let K=D.ori==0?N:Me,oe=D.ori==1?N:Me;if(zt<0||jt==0||G){L=ce.idx=null;for(let de=0;de<v.length;de++){let be=ft[de];be!=null&&Oi(be,-10,-10,N,Me)}tt&&Di(null,xr,!0,_==null&&ln.setSeries),he.live&&(ne.fill(L),me=!0)}else{let de,be,Fe;s==1&&(de=D.ori==0?zt:Yt,be=Ni(de,A),L=ce.idx=yi(be,e[0],nn,sn),Fe=O(e[0][L],D,K,0));let Oe=-10,ze=-10,at=0,Tt=0,Et=!0,yt="",je="";for(let Ye=s==2?1:0;Ye<v.length;Ye++){let Gt=v[Ye],en=ne[Ye],vn=en==null?null:s==1?e[Ye][en]:e[Ye][1][en],Ut=ce.dataIdx(i,Ye,L,be),tn=Ut==null?null:s==1?e[Ye][Ut]:e[Ye][1][Ut];if(me=me||tn!=vn||Ut!=en,ne[Ye]=Ut,Ye>0&&Gt.show){let Wn=Ut==null?-10:Ut==L?Fe:O(s==1?e[0][Ut]:e[Ye][0][Ut],D,K,0),Dn=tn==null?-10:I(tn,s==1?S[Gt.scale]:S[Gt.facets[1].scale],oe,0);if(tt&&tn!=null){let oi=D.ori==1?zt:Yt,gi=dn(Ve.dist(i,Ye,Ut,Dn,oi));if(gi<$i){let Ui=Ve.bias;if(Ui!=0){let Xn=Ni(oi,Gt.scale),ai=tn>=0?1:-1,_i=Xn>=0?1:-1;_i==ai&&(_i==1?Ui==1?tn>=Xn:tn<=Xn:Ui==1?tn<=Xn:tn>=Xn)&&($i=gi,ps=Ye)}else $i=gi,ps=Ye}}if(me||Ie){let oi,gi;D.ori==0?(oi=Wn,gi=Dn):(oi=Dn,gi=Wn);let Ui,Xn,ai,_i,Fi,Nn,qn=!0,Os=le.bbox;if(Os!=null){qn=!1;let Un=Os(i,Ye);ai=Un.left,_i=Un.top,Ui=Un.width,Xn=Un.height}else ai=oi,_i=gi,Ui=Xn=le.size(i,Ye);if(Nn=le.fill(i,Ye),Fi=le.stroke(i,Ye),Ie)Ye==ps&&$i<=Ve.prox&&(Oe=ai,ze=_i,at=Ui,Tt=Xn,Et=qn,yt=Nn,je=Fi);else{let Un=ft[Ye];Un!=null&&(kt[Ye]=ai,In[Ye]=_i,yd(Un,Ui,Xn,qn),_d(Un,Nn,Fi),Oi(Un,ui(ai),ui(_i),N,Me))}}}}if(Ie){let Ye=Ve.prox,Gt=Us==null?$i<=Ye:$i>Ye||ps!=Us;if(me||Gt){let en=ft[0];en!=null&&(kt[0]=Oe,In[0]=ze,yd(en,at,Tt,Et),_d(en,yt,je),Oi(en,ui(Oe),ui(ze),N,Me))}}}if(Vt.show&&fs)if(_!=null){let[de,be]=ln.scales,[Fe,Oe]=ln.match,[ze,at]=_.cursor.sync.scales,Tt=_.cursor.drag;if(_n=Tt._x,xn=Tt._y,_n||xn){let{left:Et,top:yt,width:je,height:Ye}=_.select,Gt=_.scales[ze].ori,en=_.posToVal,vn,Ut,tn,Wn,Dn,oi=de!=null&&Fe(de,ze),gi=be!=null&&Oe(be,at);oi&&_n?(Gt==0?(vn=Et,Ut=je):(vn=yt,Ut=Ye),tn=S[de],Wn=O(en(vn,ze),tn,K,0),Dn=O(en(vn+Ut,ze),tn,K,0),mo(vi(Wn,Dn),dn(Dn-Wn))):mo(0,K),gi&&xn?(Gt==1?(vn=Et,Ut=je):(vn=yt,Ut=Ye),tn=S[be],Wn=I(en(vn,at),tn,oe,0),Dn=I(en(vn+Ut,at),tn,oe,0),go(vi(Wn,Dn),dn(Dn-Wn))):go(0,oe)}else au()}else{let de=dn(Ff-Nf),be=dn(Of-Uf);if(D.ori==1){let at=de;de=be,be=at}_n=Mn.x&&de>=Mn.dist,xn=Mn.y&&be>=Mn.dist;let Fe=Mn.uni;Fe!=null?_n&&xn&&(_n=de>=Fe,xn=be>=Fe,!_n&&!xn&&(be>de?xn=!0:_n=!0)):Mn.x&&Mn.y&&(_n||xn)&&(_n=xn=!0);let Oe,ze;_n&&(D.ori==0?(Oe=mr,ze=zt):(Oe=gr,ze=Yt),mo(vi(Oe,ze),dn(ze-Oe)),xn||go(0,oe)),xn&&(D.ori==1?(Oe=mr,ze=zt):(Oe=gr,ze=Yt),go(vi(Oe,ze),dn(ze-Oe)),_n||mo(0,K)),!_n&&!xn&&(mo(0,0),go(0,0))}if(Mn._x=_n,Mn._y=xn,_==null){if(P){if(Kf!=null){let[de,be]=ln.scales;ln.values[0]=de!=null?Ni(D.ori==0?zt:Yt,de):null,ln.values[1]=be!=null?Ni(D.ori==1?zt:Yt,be):null}xo(pu,i,zt,Yt,N,Me,L)}if(tt){let de=P&&ln.setSeries,be=Ve.prox;Us==null?$i<=be&&Di(ps,xr,!0,de):$i>be?Di(null,xr,!0,de):ps!=Us&&Di(ps,xr,!0,de)}}me&&(he.idx=L,su()),M!==!1&&yn("setCursor")}let ms=null;Object.defineProperty(i,"rect",{get(){return ms==null&&_o(!1),ms}});function _o(_=!1){_?ms=null:(ms=m.getBoundingClientRect(),yn("syncRect",ms))}function zf(_,M,P,L,G,K,oe){ce._lock||fs&&_!=null&&_.movementX==0&&_.movementY==0||(ru(_,M,P,L,G,K,oe,!1,_!=null),_!=null?Fs(null,!0,!0):Fs(M,!0,!1))}function ru(_,M,P,L,G,K,oe,de,be){if(ms==null&&_o(!1),et(_),_!=null)P=_.clientX-ms.left,L=_.clientY-ms.top;else{if(P<0||L<0){zt=-10,Yt=-10;return}let[Fe,Oe]=ln.scales,ze=M.cursor.sync,[at,Tt]=ze.values,[Et,yt]=ze.scales,[je,Ye]=ln.match,Gt=M.axes[0].side%2==1,en=D.ori==0?N:Me,vn=D.ori==1?N:Me,Ut=Gt?K:G,tn=Gt?G:K,Wn=Gt?L:P,Dn=Gt?P:L;if(Et!=null?P=je(Fe,Et)?a(at,S[Fe],en,0):-10:P=en*(Wn/Ut),yt!=null?L=Ye(Oe,yt)?a(Tt,S[Oe],vn,0):-10:L=vn*(Dn/tn),D.ori==1){let oi=P;P=L,L=oi}}be&&(M==null||M.cursor.event.type==pu)&&((P<=1||P>=N-1)&&(P=ks(P,N)),(L<=1||L>=Me-1)&&(L=ks(L,Me))),de?(Nf=P,Uf=L,[mr,gr]=ce.move(i,P,L)):(zt=P,Yt=L)}let ou={width:0,height:0,left:0,top:0};function au(){ya(ou,!1)}let Vf,Gf,Hf,Wf;function Xf(_,M,P,L,G,K,oe){fs=!0,_n=xn=Mn._x=Mn._y=!1,ru(_,M,P,L,G,K,oe,!0,!1),_!=null&&(ut(mu,vu,qf,!1),xo(ud,i,mr,gr,N,Me,null));let{left:de,top:be,width:Fe,height:Oe}=Vt;Vf=de,Gf=be,Hf=Fe,Wf=Oe}function qf(_,M,P,L,G,K,oe){fs=Mn._x=Mn._y=!1,ru(_,M,P,L,G,K,oe,!1,!0);let{left:de,top:be,width:Fe,height:Oe}=Vt,ze=Fe>0||Oe>0,at=Vf!=de||Gf!=be||Hf!=Fe||Wf!=Oe;if(ze&&at&&ya(Vt),Mn.setScale&&ze&&at){let Tt=de,Et=Fe,yt=be,je=Oe;if(D.ori==1&&(Tt=be,Et=Oe,yt=de,je=Fe),_n&&ds(A,Ni(Tt,A),Ni(Tt+Et,A)),xn)for(let Ye in S){let Gt=S[Ye];Ye!=A&&Gt.from==null&&Gt.min!=Ot&&ds(Ye,Ni(yt+je,Ye),Ni(yt,Ye))}au()}else ce.lock&&(ce._lock=!ce._lock,Fs(M,!0,_!=null));_!=null&&(Jt(mu,vu),xo(mu,i,zt,Yt,N,Me,null))}function V0(_,M,P,L,G,K,oe){if(ce._lock)return;et(_);let de=fs;if(fs){let be=!0,Fe=!0,Oe=10,ze,at;D.ori==0?(ze=_n,at=xn):(ze=xn,at=_n),ze&&at&&(be=zt<=Oe||zt>=N-Oe,Fe=Yt<=Oe||Yt>=Me-Oe),ze&&be&&(zt=zt<mr?0:N),at&&Fe&&(Yt=Yt<gr?0:Me),Fs(null,!0,!0),fs=!1}zt=-10,Yt=-10,ne.fill(null),Fs(null,!0,!0),de&&(fs=de)}function Yf(_,M,P,L,G,K,oe){ce._lock||(et(_),po(),au(),_!=null&&xo(dd,i,zt,Yt,N,Me,null))}function $f(){T.forEach(Wx),F(i.width,i.height,!0)}Gs(Ra,Er,$f);let yr={};yr.mousedown=Xf,yr.mousemove=zf,yr.mouseup=qf,yr.dblclick=Yf,yr.setSeries=(_,M,P,L)=>{let G=ln.match[2];P=G(i,M,P),P!=-1&&Di(P,L,!0,!1)},pe&&(ut(ud,m,Xf),ut(pu,m,zf),ut(hd,m,_=>{et(_),_o(!1)}),ut(fd,m,V0),ut(dd,m,Yf),Cu.add(i),i.syncRect=_o);let va=i.hooks=n.hooks||{};function yn(_,M,P){Ln?Nt.push([_,M,P]):_ in va&&va[_].forEach(L=>{L.call(null,i,M,P)})}(n.plugins||[]).forEach(_=>{for(let M in _.hooks)va[M]=(va[M]||[]).concat(_.hooks[M])});let Zf=(_,M,P)=>P,ln=cn({key:null,setSeries:!1,filters:{pub:wd,sub:wd},scales:[A,v[1]?v[1].scale:null],match:[Ed,Ed,Zf],values:[null,null]},ce.sync);ln.match.length==2&&ln.match.push(Zf),ce.sync=ln;let Kf=ln.key,lu=bp(Kf);function xo(_,M,P,L,G,K,oe){ln.filters.pub(_,M,P,L,G,K,oe)&&lu.pub(_,M,P,L,G,K,oe)}lu.sub(i);function G0(_,M,P,L,G,K,oe){ln.filters.sub(_,M,P,L,G,K,oe)&&yr[_](null,M,P,L,G,K,oe)}i.pub=G0;function H0(){lu.unsub(i),Cu.delete(i),Xt.clear(),Mu(Ra,Er,$f),c.remove(),_e?.remove(),yn("destroy")}i.destroy=H0;function cu(){yn("init",n,e),fo(e||n.data,!1),V[A]?tu(A,V[A]):po(),ie=Vt.show&&(Vt.width>0||Vt.height>0),ee=me=!0,F(n.width,n.height)}return v.forEach(cr),T.forEach(Wi),t?t instanceof HTMLElement?(t.appendChild(c),cu()):t(i,cu):cu(),i}wn.assign=cn;wn.fmtNum=Uu;wn.rangeNum=Pa;wn.rangeLog=Da;wn.rangeAsinh=Du;wn.orient=Ws;wn.pxRatio=Ct;wn.join=U_;wn.fmtDate=Ou,wn.tzDate=q_;wn.sync=bp;{wn.addGap=Cx,wn.clipGaps=Fa;let n=wn.paths={points:Tp};n.linear=Rp,n.stepped=Ix,n.bars=Lx,n.spline=Nx}var Xx=[[1],[1,2,5],[1,2,3,4,5,6,7,8,9]];function Dp(n,e,t){let i=Math.floor(Math.log10(n)+1e-9),s=Math.ceil(Math.log10(e)-1e-9),r=c=>c>=n*(1-1e-9)&&c<=e*(1+1e-9);for(let c of Xx){let u=Math.max(1,Math.ceil((s-i)/(1.4*t))),h=[];for(let f=i;f<=s;f++)f%u===0&&h.push(...c.map(d=>+`${d}e${f}`).filter(r));if(u>1||h.length>1&&h.length>=.5*t)return h}let o=10**Math.floor(Math.log10((e-n)/2)),a=Math.ceil(n/o-1e-9),l=Math.floor(e/o+1e-9)-a+1;return Array.from({length:l},(c,u)=>Number(((a+u)*o).toPrecision(12)))}var Np='system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans CJK SC", sans-serif',Xs=62,Up=26,qx=16,Yx=20,$x=.14;function za({panels:n,abreast:e},t){let i=e>1||t===n.length-1,s=e>1?140:{1:270,2:200}[n.length]??158,r=t<e;return{last:i,named:r,height:s+(i?Up:6)}}function Va(n){let{panel:e,palette:t,magnified:i,shared:s}=n,r=`${12*i}px ${Np}`,o={stroke:t.grid,width:i},a=e.lines.map(h=>{let{width:f,dash:d}=Sr(h.stroke,h.colour);return{label:h.name,stroke:()=>t.line(h.colour),width:f*i,dash:d?.map(m=>m*i),gaps:(m,y,p,g,v)=>v.map(([T,S])=>[T-i,S+i]),points:{show:h.points,size:5*i,width:0,fill:()=>t.line(h.colour)}}}),l=h=>(f,d,m,y)=>Dp(m,y,Math.max(2,(d?f.bbox.height:f.bbox.width)/devicePixelRatio/(h*i))),c=h=>({splits:l(h),filter:(f,d)=>d}),u={width:n.width,height:n.height,padding:[(n.named&&n.rules.length?7+qx:7)*i,10*i,0,0],legend:{show:!1},focus:{alpha:$x},cursor:{show:!!s,y:!1,points:{size:7,fill:t.paper,width:1.6},drag:{x:!0,y:!1,dist:4},hover:{prox:(h,f,d)=>h.data[f][d]===void 0?Yx:null},sync:s&&{key:s.key,scales:["x",null],setSeries:!1,filters:{pub:h=>h==="mousemove"||h==="mouseleave",sub:s.listens}}},scales:{x:{time:!1,distr:n.logAcross?3:1,range:(h,f,d)=>[f,d]},y:{distr:e.log?3:1,...e.ends&&{range:e.ends}}},axes:[{grid:o,font:r,stroke:t.muted,ticks:{...o,size:4*i,show:n.last},size:(n.last?Up:6)*i,gap:3*i,space:60*i,...n.logAcross?c(34):{},values:(h,f)=>n.last?fu(f,n.logAcross):f.map(()=>"")},{grid:o,font:r,stroke:t.muted,ticks:{...o,size:4*i},size:Xs*i,gap:4*i,space:30*i,...e.log?c(30):{},values:(h,f)=>fu(f,e.log)}],series:[{},...a],hooks:{setCursor:[h=>n.onCursor?.(h.cursor.idx??null)],setScale:[(h,f)=>{let{min:d,max:m}=h.scales.x;f==="x"&&d!=null&&m!=null&&n.onRange?.(d,m)}],drawClear:[h=>Zx(h,n)],draw:[h=>Kx(h,n)]}};return new wn(u,[n.across,...n.values])}function Zx(n,{rules:e,named:t,palette:i,magnified:s}){let{ctx:r}=n,o=r.canvas.width/n.width*s,{left:a,top:l,width:c,height:u}=n.bbox;r.save(),r.strokeStyle=i.axis(),r.fillStyle=i.muted(),r.lineWidth=o,r.font=`${11*o}px ${Np}`,r.textBaseline="alphabetic",r.textAlign="left";let h=-1/0;for(let{across:f,name:d,side:m}of e){let y=n.valToPos(f,"x",!0);if(!(y>=a-1&&y<=a+c+1)||(r.beginPath(),r.moveTo(y,l),r.lineTo(y,l+u),r.stroke(),!t))continue;let p=r.measureText(d).width,g={start:y+2*o,center:y-p/2,end:y-p-2*o}[m],v=Math.min(Math.max(g,a),a+c-p);v<h||(r.fillText(d,v,l-5*o),h=v+p+8*o)}r.restore()}function Kx(n,{panel:{mark:e,lines:t},palette:i,magnified:s}){if(!e||!n.series[e.line+1].show)return;let r=n.valToPos(e.across,"x",!0),o=n.valToPos(e.value,"y",!0),{left:a,top:l,width:c,height:u}=n.bbox;if(r<a||r>a+c||o<l||o>l+u)return;let h=n.ctx.canvas.width/n.width*s;n.ctx.save(),n.ctx.setLineDash([]),n.ctx.beginPath(),n.ctx.arc(r,o,3.6*h,0,2*Math.PI),n.ctx.fillStyle=i.paper(),n.ctx.fill(),n.ctx.lineWidth=1.6*h,n.ctx.strokeStyle=i.line(t[e.line].colour),n.ctx.stroke(),n.ctx.restore()}var Ji=2,Jx=26,Fp=44,Ga=940;async function Op(n){let{entry:e,palette:t}=n;t.onPaper=!0;let i=e.panels.map((p,g)=>jx(n,g));await new Promise(p=>setTimeout(p,0));let{abreast:s}=e,r=Ga/s,o=s>1?Jx:Fp,a=i.map(p=>o+p.height/Ji),l=26+(e.heading?Fp:0),c=Math.max(...a),u=s>1?l+c*Math.ceil(i.length/s):a.reduce((p,g)=>p+g,l),h=document.createElement("canvas");h.width=Ga*Ji,h.height=(u+28)*Ji;let f=h.getContext("2d");if(!f)return null;f.fillStyle=t.paper(),f.fillRect(0,0,h.width,h.height);let d=Qx(f),m=(p,g,v)=>{let T=g;for(let S of p.lines.filter(C=>C.name&&!n.hidden.has(C.name))){let{width:C,dash:A}=Sr(S.stroke,S.colour);f.strokeStyle=t.line(S.colour),f.lineWidth=Math.max(2.4,C),f.setLineDash(A??[]),f.beginPath(),f.moveTo(T,v-4),f.lineTo(T+20,v-4),f.stroke(),T+=26+d(S.name,T+25,v,{})+14}};d(e.title,Xs,20,{bold:!0,size:15}),e.heading&&d(e.heading,Xs,44,{bold:!0}),s>1&&m(e.panels[0],Xs,63);let y=l;e.panels.forEach((p,g)=>{let v=g%s*r;d(br(p.title,p.unit),v+Xs,y+18,{bold:!0}),d(p.remark,v+r-10,y+18,{end:!0,colour:t.muted()}),s===1&&m(p,Xs,y+37);let{ctx:T,height:S}=i[g];f.drawImage(T.canvas,v,y+o,r,S/Ji),s===1?y+=a[g]:g%s===s-1&&(y+=c)}),d(br(Bs(e),e.across.unit),Ga-10,u+14,{end:!0,colour:t.muted()});for(let p of i)p.destroy();return t.onPaper=!1,new Promise(p=>h.toBlob(p,"image/png"))}function jx({entry:n,numbers:e,palette:t,hidden:i,range:s},r){let o=n.panels[r],{height:a,...l}=za(n,r),c=Va({panel:o,palette:t,...l,across:e.across,values:e.panels[r],logAcross:n.across.log,rules:n.rules,width:Ga/n.abreast*Ji,height:a*Ji,magnified:Ji});return c.setScale("x",{min:s[0],max:s[1]}),o.lines.forEach((u,h)=>i.has(u.name)&&c.setSeries(h+1,{show:!1})),c}function Qx(n){return n.scale(Ji,Ji),(e,t,i,{bold:s,end:r,size:o=12.5,colour:a="#1f2933"})=>(n.font=`${s?"600 ":""}${o}px system-ui, -apple-system, "Noto Sans CJK SC", sans-serif`,n.fillStyle=a,n.textAlign=r?"end":"start",n.fillText(e,t,i),n.measureText(e).width)}var Ha=class{constructor(e,t,i,s){this.file=e;this.entry=t;this.numbers=i;this.drawing=s;this.palette=new Ma,this.range=this.ends,this.grid.style.setProperty("--abreast",String(t.abreast)),this.grid.classList.toggle("abreast",t.abreast>1),this.element.append(this.palette.probe,this.bar(),this.heading(),this.grid),t.panels.forEach((r,o)=>this.panes.push(this.pane(o))),this.grid.append(...this.panes.map(({element:r})=>r)),this.element.append(this.below()),this.element.setAttribute("role","group"),this.element.setAttribute("aria-label",s.querySelector("title")?.textContent??t.title),this.follow(),this.choose()}file;entry;numbers;drawing;element=qs("curves");panes=[];hidden=new Set;grid=qs("curves-grid");names;range;palette;readout=document.createElement("output");whole=Wu(li.whole,li.wholeHint,()=>this.enlarge(...this.ends));seen=!0;get ends(){let{across:e}=this.numbers;return[e[0],e[e.length-1]]}bar(){let e=document.createElement("span");e.className="curves-hint",e.textContent=li.hint,this.whole.disabled=!0;let t=this.file.replace(/\.svg$/,""),i=Wu("CSV",li.csv,()=>{hu(`${t}.csv`,new Blob(["\uFEFF",sd(this.entry,this.numbers)],{type:"text/csv"}))}),s=Wu("PNG",li.png,async()=>{let{entry:o,numbers:a,palette:l,hidden:c,range:u}=this,h=await Op({entry:o,numbers:a,palette:l,hidden:c,range:u});h&&hu(`${t}.png`,h)}),r=qs("curves-bar");return r.append(this.readout,e,this.whole,i,s),r}heading(){let e=qs("curves-heading"),t=document.createElement("b");return t.textContent=this.entry.heading,e.append(t),e.hidden=!this.entry.heading,this.entry.abreast>1&&(this.names=this.legend(this.entry.panels[0].lines),e.append(this.names.element)),e}legend(e){let{palette:t}=this;t.onPaper=!0;let i=new wa(e,s=>t.line(s.colour),{toggled:(s,r)=>this.toggle(s,r),lifted:s=>this.lift(s)});return t.onPaper=!1,i}pane(e){let{entry:t,numbers:i,palette:s}=this,r=t.panels[e],o=i.panels[e],a=this.legend(r.lines),l=Va({panel:r,palette:s,values:o,...za(t,e),across:i.across,logAcross:t.across.log,rules:t.rules,width:this.width/t.abreast,magnified:1,shared:{key:`curves ${t.across.name} ${t.across.unit}`,listens:()=>this.seen},onCursor:d=>{a.at(d==null?null:o.map(m=>this.told(m,d)),t.abreast>1?3:4),e===0&&this.read(d)},onRange:(d,m)=>this.enlarge(d,m)});e===0&&this.keys(l);let c=qs("curves-heading"),u=document.createElement("b");u.textContent=br(r.title,r.unit);let h=document.createElement("span");h.textContent=r.remark,c.append(u,h);let f=qs("curves-panel");return f.append(c,a.element,l.root),{element:f,plot:l,legend:a}}below(){let{entry:e}=this,t=qs("curves-below"),i=r=>String(r).replace(/\B(?=(\d{3})+$)/g," ");e.of_rows>e.rows&&t.append(li.thinned(i(e.rows),i(e.of_rows)));let s=document.createElement("span");return s.textContent=br(Bs(e),e.across.unit),t.append(s),t}read(e){let{across:t}=this.entry,i=e==null?"":`${Bs(this.entry)} ${yo(this.numbers.across[e])} ${t.unit}`;this.readout.textContent=i}told(e,t){let i=ed(e,t),s=`${yo(this.numbers.across[i])} ${this.entry.across.unit}`.trim();return{value:e[i],elsewhere:i===t?"":s}}toggle(e,t){let s=[...new Set(this.entry.panels.flatMap(r=>r.lines.map(o=>o.name)))].filter(r=>r!==e);if(t){let r=!this.hidden.has(e)&&s.every(o=>this.hidden.has(o));this.hidden=new Set(r?[]:s)}else this.hidden.delete(e)||this.hidden.add(e);this.choose()}choose(){this.names?.show(this.hidden),this.panes.forEach(({plot:e,legend:t},i)=>{this.entry.panels[i].lines.forEach((s,r)=>{let o=!this.hidden.has(s.name);e.series[r+1].show!==o&&e.setSeries(r+1,{show:o})}),t.show(this.hidden)})}lift(e){this.panes.forEach(({plot:t},i)=>{let s=this.entry.panels[i].lines.findIndex(r=>r.name===e&&!this.hidden.has(r.name));t.setSeries(s<0?null:s+1,{focus:s>=0})})}enlarge(e,t){this.range=[e,t];let[i,s]=this.ends;this.whole.disabled=e<=i&&t>=s;for(let{plot:r}of this.panes)(r.scales.x.min!==e||r.scales.x.max!==t)&&r.setScale("x",{min:e,max:t})}keys(e){let{across:t}=this.numbers;e.over.tabIndex=0,e.over.setAttribute("role","slider"),e.over.setAttribute("aria-label",li.axes(this.entry.title)),e.over.setAttribute("aria-valuemin",String(t[0])),e.over.setAttribute("aria-valuemax",String(t[t.length-1])),e.over.setAttribute("aria-valuenow",String(t[0])),e.over.addEventListener("keydown",i=>{let s=i.shiftKey?20:1,r=Math.min(t.length-1,Math.max(0,e.cursor.idx??0)),[o,a]=this.range,l={"+":(a-o)/4,"=":(a-o)/4,"-":a-o}[i.key];if(i.key==="ArrowLeft"||i.key==="ArrowRight"){let c=Math.min(t.length-1,Math.max(0,r+(i.key==="ArrowLeft"?-s:s)));this.point(c)}else if(l!==void 0){let[c,u]=this.ends,h=e.cursor.idx==null?(o+a)/2:t[r];this.enlarge(Math.max(c,h-l),Math.min(u,h+l)),this.point(r)}else if(i.key==="Escape")this.enlarge(...this.ends);else return;i.preventDefault()})}point(e){let t=this.numbers.across[e];for(let{plot:i}of this.panes)i.setCursor({left:i.valToPos(t,"x"),top:0});this.panes[0].plot.over.setAttribute("aria-valuenow",String(t)),this.panes[0].plot.over.setAttribute("aria-valuetext",this.readout.textContent??"")}get width(){return this.element.clientWidth||this.drawing.parentElement?.clientWidth||940}follow(){new ResizeObserver(()=>{if(this.element.clientWidth)for(let{plot:e,element:t}of this.panes){let i=t.clientWidth;e.width!==i&&e.setSize({width:i,height:e.height})}}).observe(this.element),new IntersectionObserver(e=>{this.seen=e[e.length-1].isIntersecting}).observe(this.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{for(let{plot:e}of this.panes)e.redraw(!1,!0)})}};function qs(n){let e=document.createElement("div");return e.className=n,e}function Wu(n,e,t){let i=document.createElement("button");return i.type="button",i.textContent=n,i.title=e,i.setAttribute("aria-label",e),i.addEventListener("click",t),i}var ey="600px";function Bp(){let n=ba("curves-data");if(!n)return;let e=document.createElement("style");e.textContent=jf+Qf,document.head.append(e);let t=new IntersectionObserver(i=>{for(let s of i.filter(r=>r.isIntersecting))t.unobserve(s.target),ty(s.target,n)},{rootMargin:ey});for(let i of document.querySelectorAll("figure[data-curves]"))t.observe(i)}async function ty(n,e){let t=n.dataset.curves??"",i=n.querySelector(":scope > svg"),s=e[t];if(!(!s||!i||s.rows<2))try{let r=new Ha(t,s,await td(s),i);n.classList.add("answers"),i.after(r.element)}catch{}}function kp(n,e,t){e.field!==void 0&&(n.field=e.field),e.time!==void 0&&(n.times[1]=e.time),e.left!==void 0&&(n.times[0]=e.left),e.beside!==void 0&&(n.beside=e.beside),e.cut!==void 0&&n.cuts.forEach((i,s)=>{i.on=e.cut?.axis===s,e.cut?.axis===s&&(i.at=e.cut.at)}),e.cutAll!==void 0&&(n.cutAll=e.cutAll),e.scale!==void 0&&(n.scale=e.scale),e.rock!==void 0&&(n.rock=e.rock),e.colourRock!==void 0&&(n.colourRock=e.colourRock),e.flow!==void 0&&(n.flow=e.flow),e.range!==void 0&&(n.range=e.range),e.parts!==void 0&&(n.shown=t.map(i=>e.parts.includes(i)))}function Wa(n){window.tremolite={...window.tremolite,view:n}}function Je(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t.filter(s=>s!==null)),i}function Bi(n,e,t){let i=Je("input",{type:"checkbox"});return i.checked=e,i.addEventListener("change",()=>t(i.checked)),{row:Je("label",{class:"view-check"},i,Je("span",{},n)),input:i}}function Xa(n,e,t,i){let s=Je("select",{},...e.map(([r,o])=>Je("option",{value:r},o)));return s.value=t,s.addEventListener("change",()=>i(s.value)),{row:Je("label",{class:"view-row"},Je("span",{},n),s),input:s}}function Xu(n,e,t,i,s){let r=Je("input",{type:"range",min:"0",max:String(e),step:"1"}),o=Je("output",{},i(t));r.value=String(t);let a=()=>{o.textContent=i(Number(r.value)),r.setAttribute("aria-valuetext",o.textContent)};a(),r.addEventListener("input",()=>{a(),s(Number(r.value))});let l=c=>{r.value=String(c),a()};return{row:Je("label",{class:"view-row view-slide"},Je("span",{},n),r,o),input:r,set:l}}function qu(n,e){let t=Je("input",{type:"number",step:"any","aria-label":n});return t.addEventListener("change",()=>{Number.isFinite(t.valueAsNumber)&&e(t.valueAsNumber)}),t}function Ys(n,e,t=""){let i=Je("button",{type:"button",...t?{title:t,"aria-label":t}:{}},n);return i.addEventListener("click",e),i}var Dr=(n,e,...t)=>Je("details",e?{open:""}:{},Je("summary",{},n),...t);/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Is={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ls={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},fm=0,yh=1,dm=2;var Qo=1,pm=2,to=3,Ds=0,kn=1,pi=2,ir=0,no=1,vh=2,bh=3,Sh=4,mm=5;var sr=100,gm=101,_m=102,xm=103,ym=104,vm=200,bm=201,Sm=202,Mm=203,Mh=204,wh=205,wm=206,Em=207,Am=208,Tm=209,Cm=210,Rm=211,Pm=212,Im=213,Lm=214,gl=0,_l=1,xl=2,$r=3,yl=4,vl=5,bl=6,Sl=7,Eh=0,Dm=1,Nm=2,Vi=0,Ah=1,Th=2,Ch=3,Rh=4,Ph=5,Ih=6,Lh=7;var Dh=300,rr=301,io=302,Kl=303,Jl=304,Ml=1e3,zi=1001,wl=1002,Sn=1003,Um=1004;var ea=1005;var En=1006,jl=1007;var os=1008;var ri=1009,Nh=1010,Uh=1011,so=1012,Ql=1013,Ai=1014,Ti=1015,Ci=1016,ec=1017,tc=1018,or=1020,Fh=35902,Oh=35899,Bh=1021,kh=1022,Ri=1023,ss=1026,as=1027,zh=1028,nc=1029,Ns=1030,ic=1031;var sc=1033,ta=33776,na=33777,ia=33778,sa=33779,rc=35840,oc=35841,ac=35842,lc=35843,cc=36196,uc=37492,hc=37496,fc=37488,dc=37489,ra=37490,pc=37491,mc=37808,gc=37809,_c=37810,xc=37811,yc=37812,vc=37813,bc=37814,Sc=37815,Mc=37816,wc=37817,Ec=37818,Ac=37819,Tc=37820,Cc=37821,Rc=36492,Pc=36494,Ic=36495,Lc=36283,Dc=36284,oa=36285,Nc=36286;var Uo=2300,El=2301,pl=2302,dh=2303,ph=2400,mh=2401,gh=2402;var Fm=3200;var Vh=0,Om=1,ls="",jn="srgb",Fo="srgb-linear",Oo="linear",It="srgb";var ml=7680;var Bm=519,km=512,zm=513,Vm=514,Gh=515,Gm=516,Hm=517,Hh=518,Wh=519,Wm=35044;var Xh="300 es",fi=2e3,Bo=2001;function ny(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function iy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ko(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Xm(){let n=ko("canvas");return n.style.display="block",n}var zp={},Qs=null;function qh(n){Qs=n}function Yh(...n){let e="THREE."+n.shift();Qs?Qs("log",e,...n):console.log(e,...n)}function qm(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=qm(n);let e="THREE."+n.shift();if(Qs)Qs("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=qm(n);let e="THREE."+n.shift();if(Qs)Qs("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Lo(...n){let e=n.join(" ");e in zp||(zp[e]=!0,Ke(...n))}function Ym(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var $m={[gl]:gl,[xl]:bl,[yl]:yl,[$r]:vl,[_l]:_l,[bl]:xl,[Sl]:Sl,[vl]:$r},wi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Tn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Vp=1234567,Do=Math.PI/180,Zr=180/Math.PI;function ro(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Tn[n&255]+Tn[n>>8&255]+Tn[n>>16&255]+Tn[n>>24&255]+"-"+Tn[e&255]+Tn[e>>8&255]+"-"+Tn[e>>16&15|64]+Tn[e>>24&255]+"-"+Tn[t&63|128]+Tn[t>>8&255]+"-"+Tn[t>>16&255]+Tn[t>>24&255]+Tn[i&255]+Tn[i>>8&255]+Tn[i>>16&255]+Tn[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function $h(n,e){return(n%e+e)%e}function sy(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function ry(n,e,t){return n!==e?(t-n)/(e-n):0}function No(n,e,t){return(1-t)*n+t*e}function oy(n,e,t,i){return No(n,e,1-Math.exp(-t*i))}function ay(n,e=1){return e-Math.abs($h(n,e*2)-e)}function ly(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function cy(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function uy(n,e){return n+Math.floor(Math.random()*(e-n+1))}function hy(n,e){return n+Math.random()*(e-n)}function fy(n){return n*(.5-Math.random())}function dy(n){n!==void 0&&(Vp=n);let e=Vp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function py(n){return n*Do}function my(n){return n*Zr}function gy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function _y(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Zh(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function xy(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),m=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*d,a*u,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Kh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Zm(n,e){if(e.constructor===Float32Array)return n;let t=Kh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Km(n,e){if(e.constructor===Float32Array)return n;let t=Kh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Jh={DEG2RAD:Do,RAD2DEG:Zr,generateUUID:ro,clamp:xt,euclideanModulo:$h,mapLinear:sy,inverseLerp:ry,lerp:No,damp:oy,pingpong:ay,smoothstep:ly,smootherstep:cy,randInt:uy,randFloat:hy,randFloatSpread:fy,seededRandom:dy,degToRad:py,radToDeg:my,isPowerOfTwo:gy,ceilPowerOfTwo:_y,floorPowerOfTwo:Zh,setQuaternionFromProperEuler:xy,normalize:Km,denormalize:Zm},lt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ei=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],m=r[o+2],y=r[o+3];if(h!==y||l!==f||c!==d||u!==m){let p=l*f+c*d+u*m+h*y;p<0&&(f=-f,d=-d,m=-m,y=-y,p=-p);let g=1-a;if(p<.9995){let v=Math.acos(p),T=Math.sin(v);g=Math.sin(g*v)/T,a=Math.sin(a*v)/T,l=l*g+f*a,c=c*g+d*a,u=u*g+m*a,h=h*g+y*a}else{l=l*g+f*a,c=c*g+d*a,u=u*g+m*a,h=h*g+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*d-c*f,e[t+1]=l*m+u*f+c*h-a*d,e[t+2]=c*m+u*d+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Gp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Gp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Yu.copy(this).projectOnVector(e),this.sub(Yu)}reflect(e){return this.sub(Yu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yu=new W,Gp=new ei,ot=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],m=i[8],y=s[0],p=s[3],g=s[6],v=s[1],T=s[4],S=s[7],C=s[2],A=s[5],x=s[8];return r[0]=o*y+a*v+l*C,r[3]=o*p+a*T+l*A,r[6]=o*g+a*S+l*x,r[1]=c*y+u*v+h*C,r[4]=c*p+u*T+h*A,r[7]=c*g+u*S+h*x,r[2]=f*y+d*v+m*C,r[5]=f*p+d*T+m*A,r[8]=f*g+d*S+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,m=t*h+i*f+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return e[0]=h*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=f*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Lo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($u.makeScale(e,t)),this}rotate(e){return Lo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($u.makeRotation(-e)),this}translate(e,t){return Lo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($u.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},$u=new ot,Hp=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Wp=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function yy(){let n={enabled:!0,workingColorSpace:Fo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=is(s.r),s.g=is(s.g),s.b=is(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=Yr(s.r),s.g=Yr(s.g),s.b=Yr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ls?Oo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Fo]:{primaries:e,whitePoint:i,transfer:Oo,toXYZ:Hp,fromXYZ:Wp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:jn},outputColorSpaceConfig:{drawingBufferColorSpace:jn}},[jn]:{primaries:e,whitePoint:i,transfer:It,toXYZ:Hp,fromXYZ:Wp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:jn}}}),n}var St=yy();function is(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Yr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Nr,Al=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Nr===void 0&&(Nr=ko("canvas")),Nr.width=e.width,Nr.height=e.height;let s=Nr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Nr}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ko("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=is(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(is(t[i]/255)*255):t[i]=is(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},vy=0,Kr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:vy++}),this.uuid=ro(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Zu(s[o].image)):r.push(Zu(s[o]))}else r=Zu(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Zu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Al.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var by=0,Ku=new W,Vn=class n extends wi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=zi,s=zi,r=En,o=os,a=Ri,l=ri,c=n.DEFAULT_ANISOTROPY,u=ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:by++}),this.uuid=ro(),this.name="",this.source=new Kr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new lt(0,0),this.repeat=new lt(1,1),this.center=new lt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ku).x}get height(){return this.source.getSize(Ku).y}get depth(){return this.source.getSize(Ku).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Dh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ml:e.x=e.x-Math.floor(e.x);break;case zi:e.x=e.x<0?0:1;break;case wl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ml:e.y=e.y-Math.floor(e.y);break;case zi:e.y=e.y<0?0:1;break;case wl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Vn.DEFAULT_IMAGE=null;Vn.DEFAULT_MAPPING=Dh;Vn.DEFAULT_ANISOTROPY=1;var Kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],y=l[2],p=l[6],g=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(m-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(m+p)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(d+1)/2,C=(g+1)/2,A=(u+f)/4,x=(h+y)/4,E=(m+p)/4;return T>S&&T>C?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=x/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=E/r),this.set(i,s,r,t),this}let v=Math.sqrt((p-m)*(p-m)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(v)<.001&&(v=1),this.x=(p-m)/v,this.y=(h-y)/v,this.z=(f-u)/v,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Tl=class extends wi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:En,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Kt(0,0,e,t),this.scissorTest=!1,this.viewport=new Kt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Vn({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:En,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Kr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ti=class extends Tl{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},zo=class extends Vn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Sn,this.minFilter=Sn,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Cl=class extends Vn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Sn,this.minFilter=Sn,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Zt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,m,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,m,y,p)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,m,y,p){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=f,g[3]=d,g[7]=m,g[11]=y,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Ur.setFromMatrixColumn(e,0).length(),r=1/Ur.setFromMatrixColumn(e,1).length(),o=1/Ur.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,m=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+m*c,t[5]=f-y*c,t[9]=-a*l,t[2]=y-f*c,t[6]=m+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,m=c*u,y=c*h;t[0]=f+y*a,t[4]=m*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-m,t[6]=y+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,m=c*u,y=c*h;t[0]=f-y*a,t[4]=-o*h,t[8]=m+d*a,t[1]=d+m*a,t[5]=o*u,t[9]=y-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,m=a*u,y=a*h;t[0]=l*u,t[4]=m*c-d,t[8]=f*c+y,t[1]=l*h,t[5]=y*c+f,t[9]=d*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,m=a*l,y=a*c;t[0]=l*u,t[4]=y-f*h,t[8]=m*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+m,t[10]=f-y*h}else if(e.order==="XZY"){let f=o*l,d=o*c,m=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+y,t[5]=o*u,t[9]=d*h-m,t[2]=m*h-d,t[6]=a*u,t[10]=y*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Sy,e,My)}lookAt(e,t,i){let s=this.elements;return Kn.subVectors(e,t),Kn.lengthSq()===0&&(Kn.z=1),Kn.normalize(),xs.crossVectors(i,Kn),xs.lengthSq()===0&&(Math.abs(i.z)===1?Kn.x+=1e-4:Kn.z+=1e-4,Kn.normalize(),xs.crossVectors(i,Kn)),xs.normalize(),qa.crossVectors(Kn,xs),s[0]=xs.x,s[4]=qa.x,s[8]=Kn.x,s[1]=xs.y,s[5]=qa.y,s[9]=Kn.y,s[2]=xs.z,s[6]=qa.z,s[10]=Kn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],m=i[2],y=i[6],p=i[10],g=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=s[0],x=s[4],E=s[8],z=s[12],U=s[1],D=s[5],H=s[9],O=s[13],I=s[2],V=s[6],Y=s[10],k=s[14],ae=s[3],$=s[7],J=s[11],ne=s[15];return r[0]=o*A+a*U+l*I+c*ae,r[4]=o*x+a*D+l*V+c*$,r[8]=o*E+a*H+l*Y+c*J,r[12]=o*z+a*O+l*k+c*ne,r[1]=u*A+h*U+f*I+d*ae,r[5]=u*x+h*D+f*V+d*$,r[9]=u*E+h*H+f*Y+d*J,r[13]=u*z+h*O+f*k+d*ne,r[2]=m*A+y*U+p*I+g*ae,r[6]=m*x+y*D+p*V+g*$,r[10]=m*E+y*H+p*Y+g*J,r[14]=m*z+y*O+p*k+g*ne,r[3]=v*A+T*U+S*I+C*ae,r[7]=v*x+T*D+S*V+C*$,r[11]=v*E+T*H+S*Y+C*J,r[15]=v*z+T*O+S*k+C*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],m=e[3],y=e[7],p=e[11],g=e[15],v=l*d-c*f,T=a*d-c*h,S=a*f-l*h,C=o*d-c*u,A=o*f-l*u,x=o*h-a*u;return t*(y*v-p*T+g*S)-i*(m*v-p*C+g*A)+s*(m*T-y*C+g*x)-r*(m*S-y*A+p*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],m=e[12],y=e[13],p=e[14],g=e[15],v=t*a-i*o,T=t*l-s*o,S=t*c-r*o,C=i*l-s*a,A=i*c-r*a,x=s*c-r*l,E=u*y-h*m,z=u*p-f*m,U=u*g-d*m,D=h*p-f*y,H=h*g-d*y,O=f*g-d*p,I=v*O-T*H+S*D+C*U-A*z+x*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return e[0]=(a*O-l*H+c*D)*V,e[1]=(s*H-i*O-r*D)*V,e[2]=(y*x-p*A+g*C)*V,e[3]=(f*A-h*x-d*C)*V,e[4]=(l*U-o*O-c*z)*V,e[5]=(t*O-s*U+r*z)*V,e[6]=(p*S-m*x-g*T)*V,e[7]=(u*x-f*S+d*T)*V,e[8]=(o*H-a*U+c*E)*V,e[9]=(i*U-t*H-r*E)*V,e[10]=(m*A-y*S+g*v)*V,e[11]=(h*S-u*A-d*v)*V,e[12]=(a*z-o*D-l*E)*V,e[13]=(t*D-i*z+s*E)*V,e[14]=(y*T-m*C-p*v)*V,e[15]=(u*C-h*T+f*v)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,m=r*h,y=o*u,p=o*h,g=a*h,v=l*c,T=l*u,S=l*h,C=i.x,A=i.y,x=i.z;return s[0]=(1-(y+g))*C,s[1]=(d+S)*C,s[2]=(m-T)*C,s[3]=0,s[4]=(d-S)*A,s[5]=(1-(f+g))*A,s[6]=(p+v)*A,s[7]=0,s[8]=(m+T)*x,s[9]=(p-v)*x,s[10]=(1-(f+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Ur.set(s[0],s[1],s[2]).length(),a=Ur.set(s[4],s[5],s[6]).length(),l=Ur.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,u=1/a,h=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=h,bi.elements[9]*=h,bi.elements[10]*=h,t.setFromRotationMatrix(bi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=fi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===fi)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Bo)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=fi,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===fi)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===Bo)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ur=new W,bi=new Zt,Sy=new W(0,0,0),My=new W(1,1,1),xs=new W,qa=new W,Kn=new W,Xp=new Zt,qp=new ei,ws=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Xp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Xp,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return qp.setFromEuler(this),this.setFromQuaternion(qp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ws.DEFAULT_ORDER="XYZ";var Vo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},wy=0,Yp=new W,Fr=new ei,ji=new Zt,Ya=new W,To=new W,Ey=new W,Ay=new ei,$p=new W(1,0,0),Zp=new W(0,1,0),Kp=new W(0,0,1),Jp={type:"added"},Ty={type:"removed"},Or={type:"childadded",child:null},Ju={type:"childremoved",child:null},ni=class n extends wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:wy++}),this.uuid=ro(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new W,t=new ws,i=new ei,s=new W(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Zt},normalMatrix:{value:new ot}}),this.matrix=new Zt,this.matrixWorld=new Zt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Vo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Fr.setFromAxisAngle(e,t),this.quaternion.multiply(Fr),this}rotateOnWorldAxis(e,t){return Fr.setFromAxisAngle(e,t),this.quaternion.premultiply(Fr),this}rotateX(e){return this.rotateOnAxis($p,e)}rotateY(e){return this.rotateOnAxis(Zp,e)}rotateZ(e){return this.rotateOnAxis(Kp,e)}translateOnAxis(e,t){return Yp.copy(e).applyQuaternion(this.quaternion),this.position.add(Yp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis($p,e)}translateY(e){return this.translateOnAxis(Zp,e)}translateZ(e){return this.translateOnAxis(Kp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ji.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Ya.copy(e):Ya.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),To.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ji.lookAt(To,Ya,this.up):ji.lookAt(Ya,To,this.up),this.quaternion.setFromRotationMatrix(ji),s&&(ji.extractRotation(s.matrixWorld),Fr.setFromRotationMatrix(ji),this.quaternion.premultiply(Fr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Jp),Or.child=e,this.dispatchEvent(Or),Or.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ty),Ju.child=e,this.dispatchEvent(Ju),Ju.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ji.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ji.multiply(e.parent.matrixWorld)),e.applyMatrix4(ji),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Jp),Or.child=e,this.dispatchEvent(Or),Or.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(To,e,Ey),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(To,Ay,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ni.DEFAULT_UP=new W(0,1,0);ni.DEFAULT_MATRIX_AUTO_UPDATE=!0;ni.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var js=class extends ni{constructor(){super(),this.isGroup=!0,this.type="Group"}},Cy={type:"move"},Jr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new js,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new js,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new js,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,i),g=this._getHandJoint(c,y);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Cy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new js;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Jm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ys={h:0,s:0,l:0},$a={h:0,s:0,l:0};function ju(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ht=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=jn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=$h(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=ju(o,r,e+1/3),this.g=ju(o,r,e),this.b=ju(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=jn){function i(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=jn){let i=Jm[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=is(e.r),this.g=is(e.g),this.b=is(e.b),this}copyLinearToSRGB(e){return this.r=Yr(e.r),this.g=Yr(e.g),this.b=Yr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=jn){return St.workingToColorSpace(Cn.copy(this),e),Math.round(xt(Cn.r*255,0,255))*65536+Math.round(xt(Cn.g*255,0,255))*256+Math.round(xt(Cn.b*255,0,255))}getHexString(e=jn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Cn.copy(this),t);let i=Cn.r,s=Cn.g,r=Cn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Cn.copy(this),t),e.r=Cn.r,e.g=Cn.g,e.b=Cn.b,e}getStyle(e=jn){St.workingToColorSpace(Cn.copy(this),e);let t=Cn.r,i=Cn.g,s=Cn.b;return e!==jn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(ys),this.setHSL(ys.h+e,ys.s+t,ys.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(ys),e.getHSL($a);let i=No(ys.h,$a.h,t),s=No(ys.s,$a.s,t),r=No(ys.l,$a.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Cn=new ht;ht.NAMES=Jm;var Go=class extends ni{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ws,this.environmentIntensity=1,this.environmentRotation=new ws,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Si=new W,Qi=new W,Qu=new W,es=new W,Br=new W,kr=new W,jp=new W,eh=new W,th=new W,nh=new W,ih=new Kt,sh=new Kt,rh=new Kt,Ms=class n{constructor(e=new W,t=new W,i=new W){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Si.subVectors(e,t),s.cross(Si);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Si.subVectors(s,t),Qi.subVectors(i,t),Qu.subVectors(e,t);let o=Si.dot(Si),a=Si.dot(Qi),l=Si.dot(Qu),c=Qi.dot(Qi),u=Qi.dot(Qu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return r.set(1-d-m,m,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,es)===null?!1:es.x>=0&&es.y>=0&&es.x+es.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,es.x),l.addScaledVector(o,es.y),l.addScaledVector(a,es.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return ih.setScalar(0),sh.setScalar(0),rh.setScalar(0),ih.fromBufferAttribute(e,t),sh.fromBufferAttribute(e,i),rh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(ih,r.x),o.addScaledVector(sh,r.y),o.addScaledVector(rh,r.z),o}static isFrontFacing(e,t,i,s){return Si.subVectors(i,t),Qi.subVectors(e,t),Si.cross(Qi).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Si.subVectors(this.c,this.b),Qi.subVectors(this.a,this.b),Si.cross(Qi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Br.subVectors(s,i),kr.subVectors(r,i),eh.subVectors(e,i);let l=Br.dot(eh),c=kr.dot(eh);if(l<=0&&c<=0)return t.copy(i);th.subVectors(e,s);let u=Br.dot(th),h=kr.dot(th);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Br,o);nh.subVectors(e,r);let d=Br.dot(nh),m=kr.dot(nh);if(m>=0&&d<=m)return t.copy(r);let y=d*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(kr,a);let p=u*m-d*h;if(p<=0&&h-u>=0&&d-m>=0)return jp.subVectors(r,s),a=(h-u)/(h-u+(d-m)),t.copy(s).addScaledVector(jp,a);let g=1/(p+y+f);return o=y*g,a=f*g,t.copy(i).addScaledVector(Br,o).addScaledVector(kr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Es=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Mi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Mi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Mi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Mi):Mi.fromBufferAttribute(r,o),Mi.applyMatrix4(e.matrixWorld),this.expandByPoint(Mi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Za.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Za.copy(i.boundingBox)),Za.applyMatrix4(e.matrixWorld),this.union(Za)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Mi),Mi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Co),Ka.subVectors(this.max,Co),zr.subVectors(e.a,Co),Vr.subVectors(e.b,Co),Gr.subVectors(e.c,Co),vs.subVectors(Vr,zr),bs.subVectors(Gr,Vr),$s.subVectors(zr,Gr);let t=[0,-vs.z,vs.y,0,-bs.z,bs.y,0,-$s.z,$s.y,vs.z,0,-vs.x,bs.z,0,-bs.x,$s.z,0,-$s.x,-vs.y,vs.x,0,-bs.y,bs.x,0,-$s.y,$s.x,0];return!oh(t,zr,Vr,Gr,Ka)||(t=[1,0,0,0,1,0,0,0,1],!oh(t,zr,Vr,Gr,Ka))?!1:(Ja.crossVectors(vs,bs),t=[Ja.x,Ja.y,Ja.z],oh(t,zr,Vr,Gr,Ka))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Mi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Mi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ts[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ts[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ts),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ts=[new W,new W,new W,new W,new W,new W,new W,new W],Mi=new W,Za=new Es,zr=new W,Vr=new W,Gr=new W,vs=new W,bs=new W,$s=new W,Co=new W,Ka=new W,Ja=new W,Zs=new W;function oh(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Zs.fromArray(n,r);let a=s.x*Math.abs(Zs.x)+s.y*Math.abs(Zs.y)+s.z*Math.abs(Zs.z),l=e.dot(Zs),c=t.dot(Zs),u=i.dot(Zs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var un=new W,ja=new lt,Ry=0,Bn=class extends wi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ry++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Wm,this.updateRanges=[],this.gpuType=Ti,this.version=0,this._normalizationScale=e!==void 0?Kh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ja.fromBufferAttribute(this,t),ja.applyMatrix3(e),this.setXY(t,ja.x,ja.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)un.fromBufferAttribute(this,t),un.applyMatrix3(e),this.setXYZ(t,un.x,un.y,un.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)un.fromBufferAttribute(this,t),un.applyMatrix4(e),this.setXYZ(t,un.x,un.y,un.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)un.fromBufferAttribute(this,t),un.applyNormalMatrix(e),this.setXYZ(t,un.x,un.y,un.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)un.fromBufferAttribute(this,t),un.transformDirection(e),this.setXYZ(t,un.x,un.y,un.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Zm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Km(e,this.array)}};var Ho=class extends Bn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Wo=class extends Bn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var zn=class extends Bn{constructor(e,t,i){super(new Float32Array(e),t,i)}},Py=new Es,Ro=new W,ah=new W,er=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Py.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ro.subVectors(e,this.center);let t=Ro.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ro,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ah.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ro.copy(e.center).add(ah)),this.expandByPoint(Ro.copy(e.center).sub(ah))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Iy=0,hi=new Zt,lh=new ni,Hr=new W,Jn=new Es,Po=new Es,bn=new W,Ei=class n extends wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Iy++}),this.uuid=ro(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ny(e)?Wo:Ho)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ot().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return hi.makeRotationFromQuaternion(e),this.applyMatrix4(hi),this}rotateX(e){return hi.makeRotationX(e),this.applyMatrix4(hi),this}rotateY(e){return hi.makeRotationY(e),this.applyMatrix4(hi),this}rotateZ(e){return hi.makeRotationZ(e),this.applyMatrix4(hi),this}translate(e,t,i){return hi.makeTranslation(e,t,i),this.applyMatrix4(hi),this}scale(e,t,i){return hi.makeScale(e,t,i),this.applyMatrix4(hi),this}lookAt(e){return lh.lookAt(e),lh.updateMatrix(),this.applyMatrix4(lh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Hr).negate(),this.translate(Hr.x,Hr.y,Hr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Es);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Jn.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,Jn.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,Jn.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(Jn.min),this.boundingBox.expandByPoint(Jn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new er);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let i=this.boundingSphere.center;if(Jn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Po.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(Jn.min,Po.min),Jn.expandByPoint(bn),bn.addVectors(Jn.max,Po.max),Jn.expandByPoint(bn)):(Jn.expandByPoint(Po.min),Jn.expandByPoint(Po.max))}Jn.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)bn.fromBufferAttribute(a,c),l&&(Hr.fromBufferAttribute(e,c),bn.add(Hr)),s=Math.max(s,i.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Bn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let z=0;z<i.count;z++)a[z]=new W,l[z]=new W;let u=new W,h=new W,f=new W,d=new lt,m=new lt,y=new lt,p=new W,g=new W;function v(z,U,D){c[z]=c[U]=c[D]=1,u.fromBufferAttribute(i,z),h.fromBufferAttribute(i,U),f.fromBufferAttribute(i,D),d.fromBufferAttribute(r,z),m.fromBufferAttribute(r,U),y.fromBufferAttribute(r,D),h.sub(u),f.sub(u),m.sub(d),y.sub(d);let H=1/(m.x*y.y-y.x*m.y);isFinite(H)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(f,-m.y).multiplyScalar(H),g.copy(f).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(H),a[z].add(p),a[U].add(p),a[D].add(p),l[z].add(g),l[U].add(g),l[D].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let z=0,U=T.length;z<U;++z){let D=T[z],H=D.start,O=D.count;for(let I=H,V=H+O;I<V;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new W,C=new W,A=new W,x=new W;function E(z){A.fromBufferAttribute(s,z),x.copy(A);let U=a[z];S.copy(U),S.sub(A.multiplyScalar(A.dot(U))).normalize(),C.crossVectors(x,U);let H=C.dot(l[z])<0?-1:1;o.setXYZW(z,S.x,S.y,S.z,H)}for(let z=0,U=i.count;z<U;++z)c[z]&&E(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Bn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,u=new W,h=new W;if(e)for(let f=0,d=e.count;f<d;f+=3){let m=e.getX(f+0),y=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let g=0;g<u;g++)f[m++]=c[d++]}return new Bn(f,u,h)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ch=new W,Ly=new W,Dy=new ot,Qn=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=ch.subVectors(i,t).cross(Ly.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(ch),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Dy.getNormalMatrix(e),s=this.coplanarPoint(ch).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ny=0,As=class extends wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ny++}),this.uuid=ro(),this.name="",this.type="Material",this.blending=no,this.side=Ds,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Mh,this.blendDst=wh,this.blendEquation=sr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=$r,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Bm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ml,this.stencilZFail=ml,this.stencilZPass=ml,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Qn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new lt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new lt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ns=new W,uh=new W,Qa=new W,el=new W,tr=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ns)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ns.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ns.copy(this.origin).addScaledVector(this.direction,t),ns.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){uh.copy(e).add(t).multiplyScalar(.5),Qa.copy(t).sub(e).normalize(),el.copy(this.origin).sub(uh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Qa),a=el.dot(this.direction),l=-el.dot(Qa),c=el.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=r*u,h>=0)if(f>=-m)if(f<=m){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(uh).addScaledVector(Qa,f),d}intersectSphere(e,t){if(e.radius<0)return null;ns.subVectors(e.center,this.origin);let i=ns.dot(this.direction),s=ns.dot(ns)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ns)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,m=t.x-o.x,y=t.y-o.y,p=t.z-o.z,g=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(u),x,E,z,U,D,H,O,I,V,Y,k,ae;if(S>=C&&S>=A?(z=l,H=h,V=m,ae=g,l>=0?(x=c,E=u,U=f,D=d,O=y,I=p,Y=v,k=T):(x=u,E=c,U=d,D=f,O=p,I=y,Y=T,k=v)):C>=A?(z=c,H=f,V=y,ae=v,c>=0?(x=u,E=l,U=d,D=h,O=p,I=m,Y=T,k=g):(x=l,E=u,U=h,D=d,O=m,I=p,Y=g,k=T)):(z=u,H=d,V=p,ae=T,u>=0?(x=l,E=c,U=h,D=f,O=m,I=y,Y=g,k=v):(x=c,E=l,U=f,D=h,O=y,I=m,Y=v,k=g)),z===0)return null;let $=x/z,J=E/z,ne=1/z,he=U-$*H,ce=D-J*H,j=O-$*V,pe=I-J*V,ge=Y-$*ae,_e=k-J*ae,Se=ge*pe-_e*j,ke=he*_e-ce*ge,st=j*ce-pe*he;if(s){if(Se<0||ke<0||st<0)return null}else if((Se<0||ke<0||st<0)&&(Se>0||ke>0||st>0))return null;let We=Se+ke+st;if(We===0)return null;let fe=ne*(Se*H+ke*V+st*ae);return(We>0?fe<0:fe>0)?null:this.at(fe/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Rl=class extends As{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ws,this.combine=Eh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Qp=new Zt,Ks=new tr,tl=new er,em=new W,nl=new W,il=new W,sl=new W,hh=new W,rl=new W,tm=new W,ol=new W,di=class extends ni{constructor(e=new Ei,t=new Rl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){rl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(hh.fromBufferAttribute(h,e),o?rl.addScaledVector(hh,u):rl.addScaledVector(hh.sub(t),u))}t.add(rl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),tl.copy(i.boundingSphere),tl.applyMatrix4(r),Ks.copy(e.ray).recast(e.near),!(tl.containsPoint(Ks.origin)===!1&&(Ks.intersectSphere(tl,em)===null||Ks.origin.distanceToSquared(em)>(e.far-e.near)**2))&&(Qp.copy(r).invert(),Ks.copy(e.ray).applyMatrix4(Qp),!(i.boundingBox!==null&&Ks.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ks)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),T=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);s=al(this,g,e,i,c,u,h,A,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=a.getX(p),T=a.getX(p+1),S=a.getX(p+2);s=al(this,o,e,i,c,u,h,v,T,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=f.length;m<y;m++){let p=f[m],g=o[p.materialIndex],v=Math.max(p.start,d.start),T=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,C=T;S<C;S+=3){let A=S,x=S+1,E=S+2;s=al(this,g,e,i,c,u,h,A,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let m=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=m,g=y;p<g;p+=3){let v=p,T=p+1,S=p+2;s=al(this,o,e,i,c,u,h,v,T,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function Uy(n,e,t,i,s,r,o,a){let l;if(e.side===kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Ds,a),l===null)return null;ol.copy(a),ol.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ol);return c<t.near||c>t.far?null:{distance:c,point:ol.clone(),object:n}}function al(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,nl),n.getVertexPosition(l,il),n.getVertexPosition(c,sl);let u=Uy(n,e,t,i,nl,il,sl,tm);if(u){let h=new W;Ms.getBarycoord(tm,nl,il,sl,h),s&&(u.uv=Ms.getInterpolatedAttribute(s,a,l,c,h,new lt)),r&&(u.uv1=Ms.getInterpolatedAttribute(r,a,l,c,h,new lt)),o&&(u.normal=Ms.getInterpolatedAttribute(o,a,l,c,h,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};Ms.getNormal(nl,il,sl,f.normal),u.face=f,u.barycoord=h}return u}var jr=class extends Vn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Sn,u=Sn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Js=new er,Fy=new lt(.5,.5),ll=new W,nr=class{constructor(e=new Qn,t=new Qn,i=new Qn,s=new Qn,r=new Qn,o=new Qn){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=fi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],m=r[8],y=r[9],p=r[10],g=r[11],v=r[12],T=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,g-m,C-v).normalize(),s[1].setComponents(c+o,d+u,g+m,C+v).normalize(),s[2].setComponents(c+a,d+h,g+y,C+T).normalize(),s[3].setComponents(c-a,d-h,g-y,C-T).normalize(),i)s[4].setComponents(l,f,p,S).normalize(),s[5].setComponents(c-l,d-f,g-p,C-S).normalize();else if(s[4].setComponents(c-l,d-f,g-p,C-S).normalize(),t===fi)s[5].setComponents(c+l,d+f,g+p,C+S).normalize();else if(t===Bo)s[5].setComponents(l,f,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Js.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Js.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Js)}intersectsSprite(e){Js.center.set(0,0,0);let t=Fy.distanceTo(e.center);return Js.radius=.7071067811865476+t,Js.applyMatrix4(e.matrixWorld),this.intersectsSphere(Js)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(ll.x=s.normal.x>0?e.max.x:e.min.x,ll.y=s.normal.y>0?e.max.y:e.min.y,ll.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ll)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},nm=new Zt,Pl=class n{constructor(){this.coordinateSystem=fi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];nm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new nr),i[s].setFromProjectionMatrix(nm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new nr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Il=class extends As{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ll=new W,Dl=new W,im=new Zt,Io=new tr,cl=new er,fh=new W,sm=new W,Nl=class extends ni{constructor(e=new Ei,t=new Il){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Ll.fromBufferAttribute(t,s-1),Dl.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Ll.distanceTo(Dl);e.setAttribute("lineDistance",new zn(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),cl.copy(i.boundingSphere),cl.applyMatrix4(s),cl.radius+=r,e.ray.intersectsSphere(cl)===!1)return;im.copy(s).invert(),Io.copy(e.ray).applyMatrix4(im);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=u.getX(y),v=u.getX(y+1),T=ul(this,e,Io,l,g,v,y);T&&t.push(T)}if(this.isLineLoop){let y=u.getX(m-1),p=u.getX(d),g=ul(this,e,Io,l,y,p,m-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=d,p=m-1;y<p;y+=c){let g=ul(this,e,Io,l,y,y+1,y);g&&t.push(g)}if(this.isLineLoop){let y=ul(this,e,Io,l,m-1,d,m-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ul(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Ll.fromBufferAttribute(a,s),Dl.fromBufferAttribute(a,r),t.distanceSqToSegment(Ll,Dl,fh,sm)>i)return;fh.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(fh);if(!(c<e.near||c>e.far))return{distance:c,point:sm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var rm=new W,om=new W,Xo=class extends Nl{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)rm.fromBufferAttribute(t,s),om.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+rm.distanceTo(om);e.setAttribute("lineDistance",new zn(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var qo=class extends Vn{constructor(e=[],t=rr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var rs=class extends Vn{constructor(e,t,i=Ai,s,r,o,a=Sn,l=Sn,c,u=ss,h=1){if(u!==ss&&u!==as)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Kr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Yo=class extends rs{constructor(e,t=Ai,i=rr,s,r,o=Sn,a=Sn,l,c=ss){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},$o=class extends Vn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Qr=class n extends Ei{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,i,t,e,o,r,0),m("z","y","x",1,-1,i,t,-e,o,r,1),m("x","z","y",1,1,e,i,t,s,o,2),m("x","z","y",1,-1,e,i,-t,s,o,3),m("x","y","z",1,-1,e,t,i,s,r,4),m("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new zn(c,3)),this.setAttribute("normal",new zn(u,3)),this.setAttribute("uv",new zn(h,2));function m(y,p,g,v,T,S,C,A,x,E,z){let U=S/x,D=C/E,H=S/2,O=C/2,I=A/2,V=x+1,Y=E+1,k=0,ae=0,$=new W;for(let J=0;J<Y;J++){let ne=J*D-O;for(let he=0;he<V;he++){let ce=he*U-H;$[y]=ce*v,$[p]=ne*T,$[g]=I,c.push($.x,$.y,$.z),$[y]=0,$[p]=0,$[g]=A>0?1:-1,u.push($.x,$.y,$.z),h.push(he/x),h.push(1-J/E),k+=1}}for(let J=0;J<E;J++)for(let ne=0;ne<x;ne++){let he=f+ne+V*J,ce=f+ne+V*(J+1),j=f+(ne+1)+V*(J+1),pe=f+(ne+1)+V*J;l.push(he,ce,pe),l.push(ce,j,pe),ae+=6}a.addGroup(d,ae,z),d+=ae,f+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Zo=class n extends Ei{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],m=[],y=[],p=[];for(let g=0;g<u;g++){let v=g*f-o;for(let T=0;T<c;T++){let S=T*h-r;m.push(S,-v,0),y.push(0,0,1),p.push(T/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let T=v+c*g,S=v+c*(g+1),C=v+1+c*(g+1),A=v+1+c*g;d.push(T,S,A),d.push(S,C,A)}this.setIndex(d),this.setAttribute("position",new zn(m,3)),this.setAttribute("normal",new zn(y,3)),this.setAttribute("uv",new zn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function ar(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(am(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(am(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Rn(n){let e={};for(let t=0;t<n.length;t++){let i=ar(n[t]);for(let s in i)e[s]=i[s]}return e}function am(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Oy(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function jh(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var jm={clone:ar,merge:Rn},By=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ky=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ii=class extends As{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=By,this.fragmentShader=ky,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ar(e.uniforms),this.uniformsGroups=Oy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ht().setHex(s.value);break;case"v2":this.uniforms[i].value=new lt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Kt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ot().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Zt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ul=class extends ii{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Fl=class extends As{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Fm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ol=class extends As{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Wr(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function hl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ts=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Bl=class extends Ts{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ph,endingEnd:ph}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case mh:r=e,a=2*t-i;break;case gh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case mh:o=e,l=2*i-t;break;case gh:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(i-t)/(s-t),y=m*m,p=y*m,g=-f*p+2*f*y-f*m,v=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*m+1,T=(-1-d)*p+(1.5+d)*y+.5*m,S=d*p-d*y;for(let C=0;C!==a;++C)r[C]=g*o[u+C]+v*o[c+C]+T*o[l+C]+S*o[h+C];return r}},kl=class extends Ts{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},zl=class extends Ts{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Vl=class extends Ts{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-t)/(s-t),y=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*m;return r}let f=a*2,d=e-1;for(let m=0;m!==a;++m){let y=o[c+m],p=o[l+m],g=d*f+m*2,v=h[g],T=h[g+1],S=e*f+m*2,C=u[S],A=u[S+1],x=Vy(i,t,v,C,s);r[m]=Qm(x,y,T,A,p)}return r}};function Qm(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function zy(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Vy(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Qm(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=zy(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Wr(t,this.TimeBufferType),this.values=Wr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Wr(e.times,Array),values:Wr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),hl(e.settings)&&(i.settings={inTangents:Wr(e.settings.inTangents,Array),outTangents:Wr(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new zl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new kl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Bl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Vl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Uo:t=this.InterpolantFactoryMethodDiscrete;break;case El:t=this.InterpolantFactoryMethodLinear;break;case pl:t=this.InterpolantFactoryMethodSmooth;break;case dh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Uo;case this.InterpolantFactoryMethodLinear:return El;case this.InterpolantFactoryMethodSmooth:return pl;case this.InterpolantFactoryMethodBezier:return dh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;hl(this.settings)&&(lm(this.settings.inTangents,e),lm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;hl(this.settings)&&(cm(this.settings.inTangents,e),cm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&iy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===pl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let m=0;m!==i;++m){let y=t[h+m];if(y!==t[f+m]||y!==t[d+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,hl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function lm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function cm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}si.prototype.ValueTypeName="";si.prototype.TimeBufferType=Float32Array;si.prototype.ValueBufferType=Float32Array;si.prototype.DefaultInterpolation=El;var Cs=class extends si{constructor(e,t,i){super(e,t,i)}};Cs.prototype.ValueTypeName="bool";Cs.prototype.ValueBufferType=Array;Cs.prototype.DefaultInterpolation=Uo;Cs.prototype.InterpolantFactoryMethodLinear=void 0;Cs.prototype.InterpolantFactoryMethodSmooth=void 0;var Gl=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Gl.prototype.ValueTypeName="color";var Hl=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Hl.prototype.ValueTypeName="number";var Wl=class extends Ts{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)ei.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ko=class extends si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Wl(this.times,this.values,this.getValueSize(),e)}};Ko.prototype.ValueTypeName="quaternion";Ko.prototype.InterpolantFactoryMethodSmooth=void 0;var Rs=class extends si{constructor(e,t,i){super(e,t,i)}};Rs.prototype.ValueTypeName="string";Rs.prototype.ValueBufferType=Array;Rs.prototype.DefaultInterpolation=Uo;Rs.prototype.InterpolantFactoryMethodLinear=void 0;Rs.prototype.InterpolantFactoryMethodSmooth=void 0;var Xl=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Xl.prototype.ValueTypeName="vector";var ql=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},eg=new ql,Yl=class{constructor(e){this.manager=e!==void 0?e:eg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Yl.DEFAULT_MATERIAL_NAME="__DEFAULT";var fl=new W,dl=new ei,ki=new W,Jo=class extends ni{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Zt,this.projectionMatrix=new Zt,this.projectionMatrixInverse=new Zt,this.coordinateSystem=fi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(fl,dl,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fl,dl,ki.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(fl,dl,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fl,dl,ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ss=new W,um=new lt,hm=new lt,On=class extends Jo{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Zr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Do*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Zr*2*Math.atan(Math.tan(Do*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ss.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ss.x,Ss.y).multiplyScalar(-e/Ss.z),Ss.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ss.x,Ss.y).multiplyScalar(-e/Ss.z)}getViewSize(e,t){return this.getViewBounds(e,um,hm),t.subVectors(hm,um)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Do*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var $l=class extends Jo{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Xr=-90,qr=1,eo=class extends ni{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new On(Xr,qr,e,t);s.layers=this.layers,this.add(s);let r=new On(Xr,qr,e,t);r.layers=this.layers,this.add(r);let o=new On(Xr,qr,e,t);o.layers=this.layers,this.add(o);let a=new On(Xr,qr,e,t);a.layers=this.layers,this.add(a);let l=new On(Xr,qr,e,t);l.layers=this.layers,this.add(l);let c=new On(Xr,qr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===fi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Bo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Zl=class extends On{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Qh="\\[\\]\\.:\\/",Gy=new RegExp("["+Qh+"]","g"),ef="[^"+Qh+"]",Hy="[^"+Qh.replace("\\.","")+"]",Wy=/((?:WC+[\/:])*)/.source.replace("WC",ef),Xy=/(WCOD+)?/.source.replace("WCOD",Hy),qy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ef),Yy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ef),$y=new RegExp("^"+Wy+Xy+qy+Yy+"$"),Zy=["material","materials","bones","map"],_h=class{constructor(e,t,i){let s=i||Wt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Wt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Gy,"")}static parseTrackName(e){let t=$y.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Zy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Wt.Composite=_h;Wt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Wt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Wt.prototype.GetterByBindingType=[Wt.prototype._getValue_direct,Wt.prototype._getValue_array,Wt.prototype._getValue_arrayElement,Wt.prototype._getValue_toArray];Wt.prototype.SetterByBindingTypeAndVersioning=[[Wt.prototype._setValue_direct,Wt.prototype._setValue_direct_setNeedsUpdate,Wt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_array,Wt.prototype._setValue_array_setNeedsUpdate,Wt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_arrayElement,Wt.prototype._setValue_arrayElement_setNeedsUpdate,Wt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Wt.prototype._setValue_fromArray,Wt.prototype._setValue_fromArray_setNeedsUpdate,Wt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var IE=new Float32Array(1);var Ps=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=xt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(xt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var xh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var jo=class extends wi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function tf(n,e,t,i){let s=Ky(i);switch(t){case Bh:return n*e;case zh:return n*e/s.components*s.byteLength;case nc:return n*e/s.components*s.byteLength;case Ns:return n*e*2/s.components*s.byteLength;case ic:return n*e*2/s.components*s.byteLength;case kh:return n*e*3/s.components*s.byteLength;case Ri:return n*e*4/s.components*s.byteLength;case sc:return n*e*4/s.components*s.byteLength;case ta:case na:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ia:case sa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case oc:case lc:return Math.max(n,16)*Math.max(e,8)/4;case rc:case ac:return Math.max(n,8)*Math.max(e,8)/2;case cc:case uc:case fc:case dc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case hc:case ra:case pc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case mc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case gc:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case _c:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case xc:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case yc:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case vc:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case bc:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Sc:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Mc:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case wc:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Ec:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Ac:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Tc:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Cc:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Rc:case Pc:case Ic:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Lc:case Dc:return Math.ceil(n/4)*Math.ceil(e/4)*8;case oa:case Nc:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ky(n){switch(n){case ri:case Nh:return{byteLength:1,components:1};case so:case Uh:case Ci:return{byteLength:2,components:1};case ec:case tc:return{byteLength:2,components:4};case Ai:case Ql:case Ti:return{byteLength:4,components:1};case Fh:case Oh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Sg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function jy(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],y=h[d];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let y=h[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Qy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ev=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,tv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,nv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,iv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,sv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,rv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ov=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,av=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,lv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,cv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,uv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,hv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,fv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,dv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,pv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,mv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,gv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,_v=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,xv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,yv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,vv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,bv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Sv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Mv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,wv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ev=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Av=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Tv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Cv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Rv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Pv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Iv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Lv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Dv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Nv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Uv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Fv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ov=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Bv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,kv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,zv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Vv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Gv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Hv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Wv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Xv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,qv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Yv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,$v=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Zv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Kv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Jv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,jv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Qv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,eb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,tb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,nb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ib=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,rb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ob=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ab=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,lb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,cb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ub=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,hb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,fb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,db=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,pb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,mb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,_b=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,xb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,yb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,vb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,bb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Sb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Mb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,wb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Eb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ab=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Tb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Cb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Rb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Pb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ib=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Lb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Db=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Nb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Ub=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Fb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Ob=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Bb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,kb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,zb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Vb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Gb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Hb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Wb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Xb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,qb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Yb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,$b=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Zb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Kb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Jb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,jb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Qb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tS=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,iS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,rS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,oS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,aS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,lS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,cS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,uS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,hS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,fS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,dS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,mS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,_S=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,yS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,vS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,bS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,MS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ES=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,AS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,TS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,CS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,RS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,PS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,IS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pt={alphahash_fragment:Qy,alphahash_pars_fragment:ev,alphamap_fragment:tv,alphamap_pars_fragment:nv,alphatest_fragment:iv,alphatest_pars_fragment:sv,aomap_fragment:rv,aomap_pars_fragment:ov,batching_pars_vertex:av,batching_vertex:lv,begin_vertex:cv,beginnormal_vertex:uv,bsdfs:hv,iridescence_fragment:fv,bumpmap_pars_fragment:dv,clipping_planes_fragment:pv,clipping_planes_pars_fragment:mv,clipping_planes_pars_vertex:gv,clipping_planes_vertex:_v,color_fragment:xv,color_pars_fragment:yv,color_pars_vertex:vv,color_vertex:bv,common:Sv,defaultnormal_vertex:Mv,displacementmap_pars_vertex:wv,displacementmap_vertex:Ev,emissivemap_fragment:Av,emissivemap_pars_fragment:Tv,colorspace_fragment:Cv,colorspace_pars_fragment:Rv,envmap_fragment:Pv,envmap_common_pars_fragment:Iv,envmap_pars_fragment:Lv,envmap_pars_vertex:Dv,envmap_physical_pars_fragment:Wv,envmap_vertex:Nv,fog_vertex:Uv,fog_pars_vertex:Fv,fog_fragment:Ov,fog_pars_fragment:Bv,gradientmap_pars_fragment:kv,lightmap_pars_fragment:zv,lights_lambert_fragment:Vv,lights_lambert_pars_fragment:Gv,lights_pars_begin:Hv,lights_toon_fragment:Xv,lights_toon_pars_fragment:qv,lights_phong_fragment:Yv,lights_phong_pars_fragment:$v,lights_physical_fragment:Zv,lights_physical_pars_fragment:Kv,lights_fragment_begin:Jv,lights_fragment_maps:jv,lights_fragment_end:Qv,lightprobes_pars_fragment:eb,logdepthbuf_fragment:tb,logdepthbuf_pars_fragment:nb,logdepthbuf_pars_vertex:ib,logdepthbuf_vertex:sb,map_fragment:rb,map_pars_fragment:ob,map_particle_fragment:ab,map_particle_pars_fragment:lb,metalnessmap_fragment:cb,metalnessmap_pars_fragment:ub,morphinstance_vertex:hb,morphcolor_vertex:fb,morphnormal_vertex:db,morphtarget_pars_vertex:pb,morphtarget_vertex:mb,normal_fragment_begin:gb,normal_fragment_maps:_b,normal_pars_fragment:xb,normal_pars_vertex:yb,normal_vertex:vb,normalmap_pars_fragment:bb,clearcoat_normal_fragment_begin:Sb,clearcoat_normal_fragment_maps:Mb,clearcoat_pars_fragment:wb,iridescence_pars_fragment:Eb,opaque_fragment:Ab,packing:Tb,premultiplied_alpha_fragment:Cb,project_vertex:Rb,dithering_fragment:Pb,dithering_pars_fragment:Ib,roughnessmap_fragment:Lb,roughnessmap_pars_fragment:Db,shadowmap_pars_fragment:Nb,shadowmap_pars_vertex:Ub,shadowmap_vertex:Fb,shadowmask_pars_fragment:Ob,skinbase_vertex:Bb,skinning_pars_vertex:kb,skinning_vertex:zb,skinnormal_vertex:Vb,specularmap_fragment:Gb,specularmap_pars_fragment:Hb,tonemapping_fragment:Wb,tonemapping_pars_fragment:Xb,transmission_fragment:qb,transmission_pars_fragment:Yb,uv_pars_fragment:$b,uv_pars_vertex:Zb,uv_vertex:Kb,worldpos_vertex:Jb,background_vert:jb,background_frag:Qb,backgroundCube_vert:eS,backgroundCube_frag:tS,cube_vert:nS,cube_frag:iS,depth_vert:sS,depth_frag:rS,distance_vert:oS,distance_frag:aS,equirect_vert:lS,equirect_frag:cS,linedashed_vert:uS,linedashed_frag:hS,meshbasic_vert:fS,meshbasic_frag:dS,meshlambert_vert:pS,meshlambert_frag:mS,meshmatcap_vert:gS,meshmatcap_frag:_S,meshnormal_vert:xS,meshnormal_frag:yS,meshphong_vert:vS,meshphong_frag:bS,meshphysical_vert:SS,meshphysical_frag:MS,meshtoon_vert:wS,meshtoon_frag:ES,points_vert:AS,points_frag:TS,shadow_vert:CS,shadow_frag:RS,sprite_vert:PS,sprite_frag:IS},Ue={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new lt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new lt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},Hi={basic:{uniforms:Rn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Rn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Rn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Rn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Rn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new ht(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Rn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Rn([Ue.points,Ue.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Rn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Rn([Ue.common,Ue.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Rn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Rn([Ue.sprite,Ue.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Rn([Ue.common,Ue.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Rn([Ue.lights,Ue.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};Hi.physical={uniforms:Rn([Hi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new lt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new lt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new lt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Uc={r:0,b:0,g:0},LS=new Zt,Mg=new ot;Mg.set(-1,0,0,0,1,0,0,0,1);function DS(n,e,t,i,s,r){let o=new ht(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function m(v){let T=!1,S=d(v);S===null?p(o,a):S&&S.isColor&&(p(S,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,T){let S=d(T);S&&S.isCubeTexture?(c===void 0&&(c=new di(new Qr(1,1,1),new ii({name:"BackgroundCubeMaterial",uniforms:ar(Hi.backgroundCube.uniforms),vertexShader:Hi.backgroundCube.vertexShader,fragmentShader:Hi.backgroundCube.fragmentShader,side:kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(LS.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Mg),c.material.toneMapped=St.getTransfer(S.colorSpace)!==It,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new di(new Zo(2,2),new ii({name:"BackgroundMaterial",uniforms:ar(Hi.background.uniforms),vertexShader:Hi.background.vertexShader,fragmentShader:Hi.background.fragmentShader,side:Ds,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==It,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,T){v.getRGB(Uc,jh(n)),t.buffers.color.setClear(Uc.r,Uc.g,Uc.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:m,addToRenderList:y,dispose:g}}function NS(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(D,H,O,I,V){let Y=!1,k=h(D,I,O,H);r!==k&&(r=k,c(r.object)),Y=d(D,I,O,V),Y&&m(D,I,O,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(D,H,O,I),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function h(D,H,O,I){let V=I.wireframe===!0,Y=i[H.id];Y===void 0&&(Y={},i[H.id]=Y);let k=D.isInstancedMesh===!0?D.id:0,ae=Y[k];ae===void 0&&(ae={},Y[k]=ae);let $=ae[O.id];$===void 0&&($={},ae[O.id]=$);let J=$[V];return J===void 0&&(J=f(l()),$[V]=J),J}function f(D){let H=[],O=[],I=[];for(let V=0;V<t;V++)H[V]=0,O[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:O,attributeDivisors:I,object:D,attributes:{},index:null}}function d(D,H,O,I){let V=r.attributes,Y=H.attributes,k=0,ae=O.getAttributes();for(let $ in ae)if(ae[$].location>=0){let ne=V[$],he=Y[$];if(he===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(he=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(he=D.instanceColor)),ne===void 0||ne.attribute!==he||he&&ne.data!==he.data)return!0;k++}return r.attributesNum!==k||r.index!==I}function m(D,H,O,I){let V={},Y=H.attributes,k=0,ae=O.getAttributes();for(let $ in ae)if(ae[$].location>=0){let ne=Y[$];ne===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor));let he={};he.attribute=ne,ne&&ne.data&&(he.data=ne.data),V[$]=he,k++}r.attributes=V,r.attributesNum=k,r.index=I}function y(){let D=r.newAttributes;for(let H=0,O=D.length;H<O;H++)D[H]=0}function p(D){g(D,0)}function g(D,H){let O=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;O[D]=1,I[D]===0&&(n.enableVertexAttribArray(D),I[D]=1),V[D]!==H&&(n.vertexAttribDivisor(D,H),V[D]=H)}function v(){let D=r.newAttributes,H=r.enabledAttributes;for(let O=0,I=H.length;O<I;O++)H[O]!==D[O]&&(n.disableVertexAttribArray(O),H[O]=0)}function T(D,H,O,I,V,Y,k){k===!0?n.vertexAttribIPointer(D,H,O,V,Y):n.vertexAttribPointer(D,H,O,I,V,Y)}function S(D,H,O,I){y();let V=I.attributes,Y=O.getAttributes(),k=H.defaultAttributeValues;for(let ae in Y){let $=Y[ae];if($.location>=0){let J=V[ae];if(J===void 0&&(ae==="instanceMatrix"&&D.instanceMatrix&&(J=D.instanceMatrix),ae==="instanceColor"&&D.instanceColor&&(J=D.instanceColor)),J!==void 0){let ne=J.normalized,he=J.itemSize,ce=e.get(J);if(ce===void 0)continue;let j=ce.buffer,pe=ce.type,ge=ce.bytesPerElement,_e=pe===n.INT||pe===n.UNSIGNED_INT||J.gpuType===Ql;if(J.isInterleavedBufferAttribute){let Se=J.data,ke=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,st=J.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let We=0;We<$.locationSize;We++)g($.location+We,Se.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let We=0;We<$.locationSize;We++)p($.location+We);n.bindBuffer(n.ARRAY_BUFFER,j);for(let We=0;We<$.locationSize;We++)T($.location+We,he/$.locationSize,pe,ne,ke*ge,(st+he/$.locationSize*We)*ge,_e)}else{if(J.isInstancedBufferAttribute){for(let Se=0;Se<$.locationSize;Se++)g($.location+Se,J.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let Se=0;Se<$.locationSize;Se++)p($.location+Se);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Se=0;Se<$.locationSize;Se++)T($.location+Se,he/$.locationSize,pe,ne,he*ge,he/$.locationSize*Se*ge,_e)}}else if(k!==void 0){let ne=k[ae];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv($.location,ne);break;case 3:n.vertexAttrib3fv($.location,ne);break;case 4:n.vertexAttrib4fv($.location,ne);break;default:n.vertexAttrib1fv($.location,ne)}}}}v()}function C(){z();for(let D in i){let H=i[D];for(let O in H){let I=H[O];for(let V in I){let Y=I[V];for(let k in Y)u(Y[k].object),delete Y[k];delete I[V]}}delete i[D]}}function A(D){if(i[D.id]===void 0)return;let H=i[D.id];for(let O in H){let I=H[O];for(let V in I){let Y=I[V];for(let k in Y)u(Y[k].object),delete Y[k];delete I[V]}}delete i[D.id]}function x(D){for(let H in i){let O=i[H];for(let I in O){let V=O[I];if(V[D.id]===void 0)continue;let Y=V[D.id];for(let k in Y)u(Y[k].object),delete Y[k];delete V[D.id]}}}function E(D){for(let H in i){let O=i[H],I=D.isInstancedMesh===!0?D.id:0,V=O[I];if(V!==void 0){for(let Y in V){let k=V[Y];for(let ae in k)u(k[ae].object),delete k[ae];delete V[Y]}delete O[I],Object.keys(O).length===0&&delete i[H]}}}function z(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:z,resetDefaultState:U,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function US(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function FS(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ri&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Ci&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ri&&x!==Ti&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ke("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function OS(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Qn,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,g=n.get(h);if(!s||m===null||m.length===0||r&&!p)r?u(null):c();else{let v=r?0:i,T=v*4,S=g.clippingState||null;l.value=S,S=u(m,f,T,d);for(let C=0;C!==T;++C)S[C]=t[C];g.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,m){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,m!==!0||p===null){let g=d+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<g)&&(p=new Float32Array(g));for(let T=0,S=d;T!==y;++T,S+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var ca=class extends ti{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new qo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Qr(5,5,5),r=new ii({name:"CubemapFromEquirect",uniforms:ar(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:kn,blending:ir});r.uniforms.tEquirect.value=t;let o=new di(s,r),a=t.minFilter;return t.minFilter===os&&(t.minFilter=En),new eo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},tg=256,BS=3,kS=20,wg=256,Eg=16,zS=3,VS=new W,GS=new ht,Oc=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new eo(1,10,null),this._boxMesh=new di(new Qr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=VS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(GS));let p=new eo(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ig(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(tg,Zh(e))}_fromTexture(e,t){e.mapping===rr||e.mapping===io?this._setSize(e.image.length===0?tg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=ng(e,!1,!1),i=Math.log2(e)-BS;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ng(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===rr||e.mapping===io?(this._cubemapMaterial===null&&(this._cubemapMaterial=sg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ig()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=HS(),this._integrationMaterial=WS());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Eg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-zS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(wg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=XS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function ng(n,e,t){return new ca(n,{minFilter:os,generateMipmaps:e,type:Ci,colorSpace:Fo,depthBuffer:t})}function ua(n,e,t){return new ii({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:kn,blending:ir,depthTest:!1,depthWrite:!1})}function HS(){return ua("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${wg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function WS(){return ua("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Eg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function XS(){return ua("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${kS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function ig(){return ua("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function sg(){return ua("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function qS(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Kl||d===Jl)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let y=new ca(m.height);return y.fromEquirectangularTexture(n,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===Kl||d===Jl,y=d===rr||d===io;if(m||y){let p=t.get(f),g=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new Oc(n)),p=m?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),p.texture;if(p!==void 0)return p.texture;{let v=f.image;return m&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new Oc(n)),p=m?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),f.addEventListener("dispose",u),p.texture):null}}}return f}function a(f,d){return d===Kl?f.mapping=rr:d===Jl&&(f.mapping=io),f}function l(f){let d=0,m=6;for(let y=0;y<m;y++)f[y]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function YS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Lo("WebGLRenderer: "+i+" extension not supported."),s}}}function $S(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let p in m.attributes)e.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(e.remove(y),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(m){let y=m.attributes;for(let p in y)e.update(y[p],n.ARRAY_BUFFER)}function h(m){let y=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,T=p.count>=65535?Wo:Ho,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let x=y.array;g=y.version;for(let E=0,z=0;E<v;E+=3){let U=x[E+0],D=x[E+1],H=x[E+2];C[z++]=U,C[z++]=D,C[z++]=D,C[z++]=H,C[z++]=H,C[z++]=U}}else{g=p.version;for(let x=0,E=0;x<v;x+=3){let z=x+0,U=x+1,D=x+2;C[E++]=z,C[E++]=U,C[E++]=U,C[E++]=D,C[E++]=D,C[E++]=z}}S.version=g;let A=r.get(m);A&&e.remove(A),r.set(m,S)}function f(m){let y=r.get(m);if(y){let p=m.index;p!==null&&y.version<p.version&&h(m)}else h(m);return r.get(m)}function d(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function ZS(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function KS(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function JS(n,e,t){let i=new WeakMap,s=new Kt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let z=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",z)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;d===!0&&(T=1),m===!0&&(T=2),y===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*C*4*h),x=new zo(A,S,C,h);x.type=Ti,x.needsUpdate=!0;let E=T*4;for(let U=0;U<h;U++){let D=p[U],H=g[U],O=v[U],I=S*C*4*U;for(let V=0;V<D.count;V++){let Y=V*E;d===!0&&(s.fromBufferAttribute(D,V),A[I+Y+0]=s.x,A[I+Y+1]=s.y,A[I+Y+2]=s.z,A[I+Y+3]=0),m===!0&&(s.fromBufferAttribute(H,V),A[I+Y+4]=s.x,A[I+Y+5]=s.y,A[I+Y+6]=s.z,A[I+Y+7]=0),y===!0&&(s.fromBufferAttribute(O,V),A[I+Y+8]=s.x,A[I+Y+9]=s.y,A[I+Y+10]=s.z,A[I+Y+11]=O.itemSize===4?s.w:1)}}f={count:h,texture:x,size:new lt(S,C)},i.set(a,f),a.addEventListener("dispose",z)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function jS(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var QS={[Ah]:"LINEAR_TONE_MAPPING",[Th]:"REINHARD_TONE_MAPPING",[Ch]:"CINEON_TONE_MAPPING",[Rh]:"ACES_FILMIC_TONE_MAPPING",[Ih]:"AGX_TONE_MAPPING",[Lh]:"NEUTRAL_TONE_MAPPING",[Ph]:"CUSTOM_TONE_MAPPING"};function eM(n,e,t,i,s,r){let o=new ti(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ei;u.setAttribute("position",new zn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new zn([0,2,0,0,2,0],2));let h=new Ul({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new di(u,h),d=new $l(-1,1,1,-1,0,1),m=null,y=null,p=!1,g,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let x=0;x<T.length;x++){let E=T[x];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,x=o.height;T.length>0&&a===null&&(a=new ti(A,x,{type:Ci,depthBuffer:!1,stencilBuffer:!1}),l=new ti(A,x,{type:Ci,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&T.some(z=>z.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new rs(A,x),r===!0&&(c.format=as,c.type=or)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let z=0;z<T.length;z++){let U=T[z];U.setSize&&U.setSize(A,x),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(C,A){if(p||C.toneMapping===Vi&&T.length===0)return!1;if(v=A,A!==null){let x=A.width,E=A.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=Vi,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=g,p=!0;let x=o,E=a;for(let z=0;z<T.length;z++){let U=T[z];U.enabled!==!1&&(U.render(C,E,x,A),U.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(m!==C.outputColorSpace||y!==C.toneMapping){m=C.outputColorSpace,y=C.toneMapping,h.defines={},St.getTransfer(m)===It&&(h.defines.SRGB_TRANSFER="");let z=QS[y];z&&(h.defines[z]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(f,d),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Ag=new Vn,Tg=new rs(1,1),Cg=new Yo(1),Rg=new zo,Pg=new Cl,Ig=new qo,rg=[],og=[],ag=new Float32Array(16),lg=new Float32Array(9),cg=new Float32Array(4);function ao(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=rg[s];if(r===void 0&&(r=new Float32Array(s),rg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function pn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function mn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function kc(n,e){let t=og[e];t===void 0&&(t=new Int32Array(e),og[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function tM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function nM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2fv(this.addr,e),mn(t,e)}}function iM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(pn(t,e))return;n.uniform3fv(this.addr,e),mn(t,e)}}function sM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4fv(this.addr,e),mn(t,e)}}function rM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;cg.set(i),n.uniformMatrix2fv(this.addr,!1,cg),mn(t,i)}}function oM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;lg.set(i),n.uniformMatrix3fv(this.addr,!1,lg),mn(t,i)}}function aM(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;ag.set(i),n.uniformMatrix4fv(this.addr,!1,ag),mn(t,i)}}function lM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function cM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2iv(this.addr,e),mn(t,e)}}function uM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;n.uniform3iv(this.addr,e),mn(t,e)}}function hM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4iv(this.addr,e),mn(t,e)}}function fM(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function dM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2uiv(this.addr,e),mn(t,e)}}function pM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;n.uniform3uiv(this.addr,e),mn(t,e)}}function mM(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4uiv(this.addr,e),mn(t,e)}}function zc(n){return n.version===0&&(n.compareFunction=Wh,n.needsUpdate=!0),n}function gM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=zc(Tg):r=Ag,t.setTexture2D(e||r,s)}function _M(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Pg,s)}function xM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=zc(Cg):r=Ig,t.setTextureCube(e||r,s)}function yM(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Rg,s)}function vM(n){switch(n){case 5126:return tM;case 35664:return nM;case 35665:return iM;case 35666:return sM;case 35674:return rM;case 35675:return oM;case 35676:return aM;case 5124:case 35670:return lM;case 35667:case 35671:return cM;case 35668:case 35672:return uM;case 35669:case 35673:return hM;case 5125:return fM;case 36294:return dM;case 36295:return pM;case 36296:return mM;case 35678:case 36198:case 36298:case 36306:case 35682:return gM;case 35679:case 36299:case 36307:return _M;case 35680:case 36300:case 36308:case 36293:return xM;case 36289:case 36303:case 36311:case 36292:return yM}}function bM(n,e){n.uniform1fv(this.addr,e)}function SM(n,e){let t=ao(e,this.size,2);n.uniform2fv(this.addr,t)}function MM(n,e){let t=ao(e,this.size,3);n.uniform3fv(this.addr,t)}function wM(n,e){let t=ao(e,this.size,4);n.uniform4fv(this.addr,t)}function EM(n,e){let t=ao(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function AM(n,e){let t=ao(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function TM(n,e){let t=ao(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function CM(n,e){n.uniform1iv(this.addr,e)}function RM(n,e){n.uniform2iv(this.addr,e)}function PM(n,e){n.uniform3iv(this.addr,e)}function IM(n,e){n.uniform4iv(this.addr,e)}function LM(n,e){n.uniform1uiv(this.addr,e)}function DM(n,e){n.uniform2uiv(this.addr,e)}function NM(n,e){n.uniform3uiv(this.addr,e)}function UM(n,e){n.uniform4uiv(this.addr,e)}function FM(n,e,t){let i=this.cache,s=e.length,r=kc(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=zc(Tg):o=Ag;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function OM(n,e,t){let i=this.cache,s=e.length,r=kc(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Pg,r[o])}function BM(n,e,t){let i=this.cache,s=e.length,r=kc(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=zc(Cg):o=Ig;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function kM(n,e,t){let i=this.cache,s=e.length,r=kc(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Rg,r[o])}function zM(n){switch(n){case 5126:return bM;case 35664:return SM;case 35665:return MM;case 35666:return wM;case 35674:return EM;case 35675:return AM;case 35676:return TM;case 5124:case 35670:return CM;case 35667:case 35671:return RM;case 35668:case 35672:return PM;case 35669:case 35673:return IM;case 5125:return LM;case 36294:return DM;case 36295:return NM;case 36296:return UM;case 35678:case 36198:case 36298:case 36306:case 35682:return FM;case 35679:case 36299:case 36307:return OM;case 35680:case 36300:case 36308:case 36293:return BM;case 36289:case 36303:case 36311:case 36292:return kM}}var rf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=vM(t.type)}},of=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=zM(t.type)}},af=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},nf=/(\w+)(\])?(\[|\.)?/g;function ug(n,e){n.seq.push(e),n.map[e.id]=e}function VM(n,e,t){let i=n.name,s=i.length;for(nf.lastIndex=0;;){let r=nf.exec(i),o=nf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ug(t,c===void 0?new rf(a,n,e):new of(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new af(a),ug(t,h)),t=h}}}var oo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);VM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function hg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var GM=37297,HM=0;function WM(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var fg=new ot;function XM(n){St._getMatrix(fg,St.workingColorSpace,n);let e=`mat3( ${fg.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Oo:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function dg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+WM(n.getShaderSource(e),a)}else return r}function qM(n,e){let t=XM(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var YM={[Ah]:"Linear",[Th]:"Reinhard",[Ch]:"Cineon",[Rh]:"ACESFilmic",[Ih]:"AgX",[Lh]:"Neutral",[Ph]:"Custom"};function $M(n,e){let t=YM[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Fc=new W;function ZM(){St.getLuminanceCoefficients(Fc);let n=Fc.x.toFixed(4),e=Fc.y.toFixed(4),t=Fc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function KM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(la).join(`
`)}function JM(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function jM(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function la(n){return n!==""}function pg(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function mg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var QM=/^[ \t]*#include +<([\w\d./]+)>/gm;function lf(n){return n.replace(QM,ew)}function ew(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return lf(t)}var tw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function gg(n){return n.replace(tw,nw)}function nw(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function _g(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var iw={[Qo]:"SHADOWMAP_TYPE_PCF",[to]:"SHADOWMAP_TYPE_VSM"};function sw(n){return iw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var rw={[io]:"ENVMAP_MODE_REFRACTION"};function ow(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":rw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var aw={[Eh]:"ENVMAP_BLENDING_MULTIPLY",[Dm]:"ENVMAP_BLENDING_MIX",[Nm]:"ENVMAP_BLENDING_ADD"};function lw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":aw[n.combine]||"ENVMAP_BLENDING_NONE"}function cw(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=sw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=ow(t),h=lw(t),f=KM(t),d=JM(r),m=s.createProgram(),y,p,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(la).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(la).join(`
`),p.length>0&&(p+=`
`)):(y=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(la).join(`
`),p=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Vi?"#define TONE_MAPPING":"",t.toneMapping!==Vi?pt.tonemapping_pars_fragment:"",t.toneMapping!==Vi?$M("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,qM("linearToOutputTexel",t.outputColorSpace),ZM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(la).join(`
`)),o=lf(o),o=pg(o,t),o=mg(o,t),a=lf(a),a=pg(a,t),a=mg(a,t),o=gg(o),a=gg(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===Xh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Xh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=g+y+o,T=g+p+a,S=hg(s,s.VERTEX_SHADER,v),C=hg(s,s.FRAGMENT_SHADER,T);s.attachShader(m,S),s.attachShader(m,C),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(U){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(m)||"",H=s.getShaderInfoLog(S)||"",O=s.getShaderInfoLog(C)||"",I=D.trim(),V=H.trim(),Y=O.trim(),k=!0,ae=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,C);else{let $=dg(s,S,"vertex"),J=dg(s,C,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+I+`
`+$+`
`+J)}else I!==""?Ke("WebGLProgram: Program Info Log:",I):(V===""||Y==="")&&(ae=!1);ae&&(U.diagnostics={runnable:k,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(S),s.deleteShader(C),x=new oo(s,m),E=jM(s,m)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(m,GM)),z},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=HM++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=C,this}var uw=0,cf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new uf(e),t.set(e,i)),i}},uf=class{constructor(e){this.id=uw++,this.code=e,this.usedTimes=0}};function hw(n){return n===Ns||n===ra||n===oa}function fw(n,e,t,i,s,r){let o=new Vo,a=new cf,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,E,z,U,D,H){let O=U.fog,I=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,k=e.get(x.envMap||V,Y),ae=f[x.type],$=i.precision;x.precision!==null&&($=i.getMaxPrecision(x.precision),$!==x.precision&&Ke("WebGLProgram.getParameters:",x.precision,"not supported, using",$,"instead."));let J=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ne=J!==void 0?J.length:0,he=0;I.morphAttributes.position!==void 0&&(he=1),I.morphAttributes.normal!==void 0&&(he=2),I.morphAttributes.color!==void 0&&(he=3);let ce,j,pe,ge;if(ae){let Ie=Hi[ae];ce=Ie.vertexShader,j=Ie.fragmentShader}else{ce=x.vertexShader,j=x.fragmentShader;let Ie=a.getVertexShaderStage(x),ft=a.getFragmentShaderStage(x);a.update(x,Ie,ft),pe=Ie.id,ge=ft.id}let _e=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),ke=D.isInstancedMesh===!0,st=D.isBatchedMesh===!0,We=!!x.map,fe=!!x.matcap,Le=!!k,Ee=Le&&k.isPMREMTexture===!0,Qe=!!x.aoMap,mt=!!x.lightMap,wt=!!x.bumpMap&&x.wireframe===!1,ct=!!x.normalMap,Xt=!!x.displacementMap,ut=!!x.emissiveMap,Jt=!!x.metalnessMap,qt=!!x.roughnessMap,Mt=x.anisotropy>0,N=x.clearcoat>0,Me=x.diffuseRoughness>0,$e=x.dispersion>0,rt=x.retroreflectivity>0,Ae=x.iridescence>0,Ft=x.sheen>0,Xe=x.transmission>0,Ze=Mt&&!!x.anisotropyMap,R=N&&!!x.clearcoatMap,b=N&&!!x.clearcoatNormalMap,X=N&&!!x.clearcoatRoughnessMap,ue=Me&&!!x.diffuseRoughnessMap,re=Ae&&!!x.iridescenceMap,ye=Ae&&!!x.iridescenceThicknessMap,ve=Ft&&!!x.sheenColorMap,ee=Ft&&!!x.sheenRoughnessMap,ie=!!x.specularMap,me=!!x.specularColorMap,F=!!x.specularIntensityMap,se=Xe&&!!x.transmissionMap,te=Xe&&!!x.thicknessMap,Te=!!x.gradientMap,xe=!!x.alphaMap,we=x.alphaTest>0,qe=!!x.alphaHash,et=!!x.extensions,le=Vi;x.toneMapped&&(_e===null||_e.isXRRenderTarget===!0)&&(le=n.toneMapping);let Ve=Ee?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,tt={shaderID:ae,shaderType:x.type,shaderName:x.name,vertexShader:ce,fragmentShader:j,defines:x.defines,customVertexShaderID:pe,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:$,batching:st,batchingColor:st&&D._colorsTexture!==null,instancing:ke,instancingColor:ke&&D.instanceColor!==null,instancingMorph:ke&&D.morphTexture!==null,outputColorSpace:_e===null?n.outputColorSpace:_e.isXRRenderTarget===!0?_e.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:We,matcap:fe,envMap:Le,envMapMode:Le&&k.mapping,envMapPMREM:Ee,envMapMaxLod:Ee?Ve.length-1:null,envMapSize:Ee?Ve[0].width:null,aoMap:Qe,lightMap:mt,bumpMap:wt,normalMap:ct,displacementMap:Xt,emissiveMap:ut,normalMapObjectSpace:ct&&x.normalMapType===Om,normalMapTangentSpace:ct&&x.normalMapType===Vh,packedNormalMap:ct&&x.normalMapType===Vh&&hw(x.normalMap.format),metalnessMap:Jt,roughnessMap:qt,anisotropy:Mt,anisotropyMap:Ze,clearcoat:N,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:Me,diffuseRoughnessMap:ue,dispersion:$e,retroreflection:rt,iridescence:Ae,iridescenceMap:re,iridescenceThicknessMap:ye,sheen:Ft,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:me,specularIntensityMap:F,transmission:Xe,transmissionMap:se,thicknessMap:te,gradientMap:Te,opaque:x.transparent===!1&&x.blending===no&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:we,alphaHash:qe,combine:x.combine,mapUv:We&&d(x.map.channel),aoMapUv:Qe&&d(x.aoMap.channel),lightMapUv:mt&&d(x.lightMap.channel),bumpMapUv:wt&&d(x.bumpMap.channel),normalMapUv:ct&&d(x.normalMap.channel),displacementMapUv:Xt&&d(x.displacementMap.channel),emissiveMapUv:ut&&d(x.emissiveMap.channel),metalnessMapUv:Jt&&d(x.metalnessMap.channel),roughnessMapUv:qt&&d(x.roughnessMap.channel),anisotropyMapUv:Ze&&d(x.anisotropyMap.channel),clearcoatMapUv:R&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:b&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:re&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:ee&&d(x.sheenRoughnessMap.channel),specularMapUv:ie&&d(x.specularMap.channel),specularColorMapUv:me&&d(x.specularColorMap.channel),specularIntensityMapUv:F&&d(x.specularIntensityMap.channel),transmissionMapUv:se&&d(x.transmissionMap.channel),thicknessMapUv:te&&d(x.thicknessMap.channel),alphaMapUv:xe&&d(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ct||Mt),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(We||xe),fog:!!O,useFog:x.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&ct===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:he,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:H.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&z.length>0,shadowMapType:n.shadowMap.type,toneMapping:le,decodeVideoTexture:We&&x.map.isVideoTexture===!0&&St.getTransfer(x.map.colorSpace)===It,decodeVideoTextureEmissive:ut&&x.emissiveMap.isVideoTexture===!0&&St.getTransfer(x.emissiveMap.colorSpace)===It,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===pi,flipSided:x.side===kn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function y(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let z in x.defines)E.push(z),E.push(x.defines[z]);return x.isRawShaderMaterial===!1&&(p(E,x),g(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function p(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function g(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let E=f[x.type],z;if(E){let U=Hi[E];z=jm.clone(U.uniforms)}else z=x.uniforms;return z}function T(x,E){let z=u.get(E);return z!==void 0?++z.usedTimes:(z=new cw(n,E,x,s),c.push(z),u.set(E,z)),z}function S(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function dw(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function pw(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function xg(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function yg(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,y,p,g){let v=n[e];return v===void 0?(v={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:g},n[e]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=m,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=p,v.group=g),e++,v}function l(f,d,m,y,p,g,v){v.reversedDepth===!0&&(p=-p);let T=a(f,d,m,y,p,g);m.transmission>0?i.push(T):m.transparent===!0?s.push(T):t.push(T)}function c(f,d,m,y,p,g){let v=a(f,d,m,y,p,g);m.transmission>0?i.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function u(f,d){t.length>1&&t.sort(f||pw),i.length>1&&i.sort(d||xg),s.length>1&&s.sort(d||xg)}function h(){for(let f=e,d=n.length;f<d;f++){let m=n[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function mw(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new yg,n.set(i,[o])):s>=r.length?(o=new yg,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function gw(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new ht};break;case"SpotLight":t={position:new W,direction:new W,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new W,halfWidth:new W,halfHeight:new W};break}return n[e.id]=t,t}}}function _w(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new lt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var xw=0;function yw(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function vw(n){let e=new gw,t=_w(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new Zt,o=new Zt;function a(c){let u=0,h=0,f=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let d=0,m=0,y=0,p=0,g=0,v=0,T=0,S=0,C=0,A=0,x=0,E=0,z=0,U=0;c.sort(yw);for(let H=0,O=c.length;H<O;H++){let I=c[H],V=I.color,Y=I.intensity,k=I.distance,ae=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Ns?ae=I.shadow.map.texture:ae=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=V.r*Y,h+=V.g*Y,f+=V.b*Y;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],Y);U++}else if(I.isSunLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,ne=t.get(I);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[m]=ne,i.sunShadowMap[m]=ae;let he=J.getViewportCount();for(let ce=0;ce<he;ce++)i.sunShadowMatrix[y+ce]=J.getMatrix(ce),i.sunShadowCascade[y+ce]=J._cascadeData[ce];y+=he,m++}i.sun[d]=$,d++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,ne=t.get(I);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,i.directionalShadow[p]=ne,i.directionalShadowMap[p]=ae,i.directionalShadowMatrix[p]=I.shadow.matrix,C++}i.directional[p]=$,p++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(V).multiplyScalar(Y),$.distance=k,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[v]=$;let J=I.shadow;if(I.map&&(i.spotLightMap[E]=I.map,E++,J.updateMatrices(I),I.castShadow&&z++),i.spotLightMatrix[v]=J.matrix,I.castShadow){let ne=t.get(I);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ae,x++}v++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(V).multiplyScalar(Y),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[T]=$,T++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let J=I.shadow,ne=t.get(I);ne.shadowIntensity=J.intensity,ne.shadowBias=J.bias,ne.shadowNormalBias=J.normalBias,ne.shadowRadius=J.radius,ne.shadowMapSize=J.mapSize,ne.shadowCameraNear=J.camera.near,ne.shadowCameraFar=J.camera.far,i.pointShadow[g]=ne,i.pointShadowMap[g]=ae,i.pointShadowMatrix[g]=I.shadow.matrix,A++}i.point[g]=$,g++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(Y),$.groundColor.copy(I.groundColor).multiplyScalar(Y),i.hemi[S]=$,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ue.LTC_FLOAT_1,i.rectAreaLTC2=Ue.LTC_FLOAT_2):(i.rectAreaLTC1=Ue.LTC_HALF_1,i.rectAreaLTC2=Ue.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let D=i.hash;(D.sunLength!==d||D.directionalLength!==p||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==T||D.hemiLength!==S||D.numSunShadows!==m||D.numDirectionalShadows!==C||D.numPointShadows!==A||D.numSpotShadows!==x||D.numSpotMaps!==E||D.numLightProbes!==U)&&(i.sun.length=d,i.directional.length=p,i.spot.length=v,i.rectArea.length=T,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-z,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=z,i.numLightProbes=U,D.sunLength=d,D.directionalLength=p,D.pointLength=g,D.spotLength=v,D.rectAreaLength=T,D.hemiLength=S,D.numSunShadows=m,D.numDirectionalShadows=C,D.numPointShadows=A,D.numSpotShadows=x,D.numSpotMaps=E,D.numLightProbes=U,i.version=xw++)}function l(c,u){let h=0,f=0,d=0,m=0,y=0,p=0,g=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),h++}else if(S.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),f++}else if(S.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(g),d++}else if(S.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:i}}function vg(n){let e=new vw(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function bw(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new vg(n),e.set(s,[a])):r>=o.length?(a=new vg(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var Sw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Mw=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,ww=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],Ew=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],bg=new Zt,aa=new W,sf=new W;function Aw(n,e,t){let i=new nr,s=new lt,r=new lt,o=new Kt,a=new Fl,l=new Ol,c={},u=t.maxTextureSize,h={[Ds]:kn,[kn]:Ds,[pi]:pi},f=new ii({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new lt},radius:{value:4}},vertexShader:Sw,fragmentShader:Mw}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new Ei;m.setAttribute("position",new Bn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new di(m,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Qo;let g=this.type;this.render=function(A,x,E){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||A.length===0)return;this.type===pm&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Qo);let z=n.getRenderTarget(),U=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),H=n.state;H.setBlending(ir),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let O=g!==this.type;O&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=A.length;I<V;I++){let Y=A[I],k=Y.shadow;if(k===void 0){Ke("WebGLShadowMap:",Y,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let ae=k.getFrameExtents();s.multiply(ae),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,k.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=$,k.map===null||O===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===to){if(Y.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new ti(s.x,s.y,{format:Ns,type:Ci,minFilter:En,magFilter:En,generateMipmaps:!1}),k.map.texture.name=Y.name+".shadowMap",k.map.depthTexture=new rs(s.x,s.y,Ti),k.map.depthTexture.name=Y.name+".shadowMapDepth",k.map.depthTexture.format=ss,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Sn,k.map.depthTexture.magFilter=Sn}else Y.isPointLight?(k.map=new ca(s.x),k.map.depthTexture=new Yo(s.x,Ai)):(k.map=new ti(s.x,s.y),k.map.depthTexture=new rs(s.x,s.y,Ai)),k.map.depthTexture.name=Y.name+".shadowMap",k.map.depthTexture.format=ss,this.type===Qo?(k.map.depthTexture.compareFunction=$?Hh:Gh,k.map.depthTexture.minFilter=En,k.map.depthTexture.magFilter=En):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Sn,k.map.depthTexture.magFilter=Sn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let J=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();Y.isPointLight!==!0&&k.updateMatrices(Y,E);let ne=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:E.layers;for(let he=0;he<J;he++){let ce=k.getCamera(he);if(Y.isPointLight){let j=k.camera,pe=k.matrix,ge=Y.distance||j.far;ge!==j.far&&(j.far=ge,j.updateProjectionMatrix()),aa.setFromMatrixPosition(Y.matrixWorld),j.position.copy(aa),sf.copy(j.position),sf.add(ww[he]),j.up.copy(Ew[he]),j.lookAt(sf),j.updateMatrixWorld(),pe.makeTranslation(-aa.x,-aa.y,-aa.z),bg.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),k._frustum.setFromProjectionMatrix(bg,j.coordinateSystem,j.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,he),n.clear();else{he===0&&(n.setRenderTarget(k.map),n.clear());let j=k.getViewport(he);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),H.viewport(o)}i=k.getFrustum(he),S(x,E,ce,Y,ne,this.type)}k.isPointLightShadow!==!0&&this.type===to&&v(k,E),k.needsUpdate=!1}g=this.type,p.needsUpdate=!1,n.setRenderTarget(z,U,D)};function v(A,x){let E=e.update(y);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new ti(s.x,s.y,{format:Ns,type:Ci}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,E,f,y,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,E,d,y,null)}function T(A,x,E,z){let U=null,D=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)U=D;else if(U=E.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let H=U.uuid,O=x.uuid,I=c[H];I===void 0&&(I={},c[H]=I);let V=I[O];V===void 0&&(V=U.clone(),I[O]=V,x.addEventListener("dispose",C)),U=V}if(U.visible=x.visible,U.wireframe=x.wireframe,z===to?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:h[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let H=n.properties.get(U);H.light=E}return U}function S(A,x,E,z,U,D){if(A.visible===!1)return;if(A.layers.test(U)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===to)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let I=e.update(A),V=A.material;if(Array.isArray(V)){let Y=I.groups;for(let k=0,ae=Y.length;k<ae;k++){let $=Y[k],J=V[$.materialIndex];if(J&&J.visible){let ne=T(A,J,z,D);A.onBeforeShadow(n,A,x,E,I,ne,$),n.renderBufferDirect(E,null,I,ne,A,$),A.onAfterShadow(n,A,x,E,I,ne,$)}}}else if(V.visible){let Y=T(A,V,z,D);A.onBeforeShadow(n,A,x,E,I,Y,null),n.renderBufferDirect(E,null,I,Y,A,null),A.onAfterShadow(n,A,x,E,I,Y,null)}}let O=A.children;for(let I=0,V=O.length;I<V;I++)S(O[I],x,E,z,U,D)}function C(A){A.target.removeEventListener("dispose",C);for(let E in c){let z=c[E],U=A.target.uuid;U in z&&(z[U].dispose(),delete z[U])}}}function Tw(n,e){function t(){let F=!1,se=new Kt,te=null,Te=new Kt(0,0,0,0);return{setMask:function(xe){te!==xe&&!F&&(n.colorMask(xe,xe,xe,xe),te=xe)},setLocked:function(xe){F=xe},setClear:function(xe,we,qe,et,le){le===!0&&(xe*=et,we*=et,qe*=et),se.set(xe,we,qe,et),Te.equals(se)===!1&&(n.clearColor(xe,we,qe,et),Te.copy(se))},reset:function(){F=!1,te=null,Te.set(-1,0,0,0)}}}function i(){let F=!1,se=!1,te=null,Te=null,xe=null;return{setReversed:function(we){if(se!==we){let qe=e.get("EXT_clip_control");we?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),se=we;let et=xe;xe=null,this.setClear(et)}},getReversed:function(){return se},setTest:function(we){we?Se(n.DEPTH_TEST):ke(n.DEPTH_TEST)},setMask:function(we){te!==we&&!F&&(n.depthMask(we),te=we)},setFunc:function(we){if(se&&(we=$m[we]),Te!==we){switch(we){case gl:n.depthFunc(n.NEVER);break;case _l:n.depthFunc(n.ALWAYS);break;case xl:n.depthFunc(n.LESS);break;case $r:n.depthFunc(n.LEQUAL);break;case yl:n.depthFunc(n.EQUAL);break;case vl:n.depthFunc(n.GEQUAL);break;case bl:n.depthFunc(n.GREATER);break;case Sl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=we}},setLocked:function(we){F=we},setClear:function(we){xe!==we&&(xe=we,se&&(we=1-we),n.clearDepth(we))},reset:function(){F=!1,te=null,Te=null,xe=null,se=!1}}}function s(){let F=!1,se=null,te=null,Te=null,xe=null,we=null,qe=null,et=null,le=null;return{setTest:function(Ve){F||(Ve?Se(n.STENCIL_TEST):ke(n.STENCIL_TEST))},setMask:function(Ve){se!==Ve&&!F&&(n.stencilMask(Ve),se=Ve)},setFunc:function(Ve,tt,Ie){(te!==Ve||Te!==tt||xe!==Ie)&&(n.stencilFunc(Ve,tt,Ie),te=Ve,Te=tt,xe=Ie)},setOp:function(Ve,tt,Ie){(we!==Ve||qe!==tt||et!==Ie)&&(n.stencilOp(Ve,tt,Ie),we=Ve,qe=tt,et=Ie)},setLocked:function(Ve){F=Ve},setClear:function(Ve){le!==Ve&&(n.clearStencil(Ve),le=Ve)},reset:function(){F=!1,se=null,te=null,Te=null,xe=null,we=null,qe=null,et=null,le=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new ht(0,0,0),z=0,U=!1,D=null,H=null,O=null,I=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,ae=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec($)[1]),k=ae>=1):$.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),k=ae>=2);let J=null,ne={},he=n.getParameter(n.SCISSOR_BOX),ce=n.getParameter(n.VIEWPORT),j=new Kt().fromArray(he),pe=new Kt().fromArray(ce);function ge(F,se,te,Te){let xe=new Uint8Array(4),we=n.createTexture();n.bindTexture(F,we),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<te;qe++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(se+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return we}let _e={};_e[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),_e[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),_e[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),_e[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc($r),wt(!1),ct(yh),Se(n.CULL_FACE),Qe(ir);function Se(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function ke(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function st(F,se){return f[F]!==se?(n.bindFramebuffer(F,se),f[F]=se,F===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=se),F===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=se),!0):!1}function We(F,se){let te=m,Te=!1;if(F){te=d.get(se),te===void 0&&(te=[],d.set(se,te));let xe=F.textures;if(te.length!==xe.length||te[0]!==n.COLOR_ATTACHMENT0){for(let we=0,qe=xe.length;we<qe;we++)te[we]=n.COLOR_ATTACHMENT0+we;te.length=xe.length,Te=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,Te=!0);Te&&n.drawBuffers(te)}function fe(F){return y!==F?(n.useProgram(F),y=F,!0):!1}let Le={[sr]:n.FUNC_ADD,[gm]:n.FUNC_SUBTRACT,[_m]:n.FUNC_REVERSE_SUBTRACT};Le[xm]=n.MIN,Le[ym]=n.MAX;let Ee={[vm]:n.ZERO,[bm]:n.ONE,[Sm]:n.SRC_COLOR,[Mh]:n.SRC_ALPHA,[Cm]:n.SRC_ALPHA_SATURATE,[Am]:n.DST_COLOR,[wm]:n.DST_ALPHA,[Mm]:n.ONE_MINUS_SRC_COLOR,[wh]:n.ONE_MINUS_SRC_ALPHA,[Tm]:n.ONE_MINUS_DST_COLOR,[Em]:n.ONE_MINUS_DST_ALPHA,[Rm]:n.CONSTANT_COLOR,[Pm]:n.ONE_MINUS_CONSTANT_COLOR,[Im]:n.CONSTANT_ALPHA,[Lm]:n.ONE_MINUS_CONSTANT_ALPHA};function Qe(F,se,te,Te,xe,we,qe,et,le,Ve){if(F===ir){p===!0&&(ke(n.BLEND),p=!1);return}if(p===!1&&(Se(n.BLEND),p=!0),F!==mm){if(F!==g||Ve!==U){if((v!==sr||C!==sr)&&(n.blendEquation(n.FUNC_ADD),v=sr,C=sr),Ve)switch(F){case no:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vh:n.blendFunc(n.ONE,n.ONE);break;case bh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Sh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",F);break}else switch(F){case no:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case vh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case bh:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Sh:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",F);break}T=null,S=null,A=null,x=null,E.set(0,0,0),z=0,g=F,U=Ve}return}xe=xe||se,we=we||te,qe=qe||Te,(se!==v||xe!==C)&&(n.blendEquationSeparate(Le[se],Le[xe]),v=se,C=xe),(te!==T||Te!==S||we!==A||qe!==x)&&(n.blendFuncSeparate(Ee[te],Ee[Te],Ee[we],Ee[qe]),T=te,S=Te,A=we,x=qe),(et.equals(E)===!1||le!==z)&&(n.blendColor(et.r,et.g,et.b,le),E.copy(et),z=le),g=F,U=!1}function mt(F,se){F.side===pi?ke(n.CULL_FACE):Se(n.CULL_FACE);let te=F.side===kn;se&&(te=!te),wt(te),F.blending===no&&F.transparent===!1?Qe(ir):Qe(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Te=F.stencilWrite;a.setTest(Te),Te&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),ut(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):ke(n.SAMPLE_ALPHA_TO_COVERAGE)}function wt(F){D!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),D=F)}function ct(F){F!==fm?(Se(n.CULL_FACE),F!==H&&(F===yh?n.cullFace(n.BACK):F===dm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):ke(n.CULL_FACE),H=F}function Xt(F){F!==O&&(k&&n.lineWidth(F),O=F)}function ut(F,se,te){F?(Se(n.POLYGON_OFFSET_FILL),(I!==se||V!==te)&&(I=se,V=te,o.getReversed()&&(se=-se,te=-te),n.polygonOffset(se,te))):ke(n.POLYGON_OFFSET_FILL)}function Jt(F){F?Se(n.SCISSOR_TEST):ke(n.SCISSOR_TEST)}function qt(F){F===void 0&&(F=n.TEXTURE0+Y-1),J!==F&&(n.activeTexture(F),J=F)}function Mt(F,se,te){te===void 0&&(J===null?te=n.TEXTURE0+Y-1:te=J);let Te=ne[te];Te===void 0&&(Te={type:void 0,texture:void 0},ne[te]=Te),(Te.type!==F||Te.texture!==se)&&(J!==te&&(n.activeTexture(te),J=te),n.bindTexture(F,se||_e[F]),Te.type=F,Te.texture=se)}function N(){let F=ne[J];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Me(){try{n.compressedTexImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function $e(){try{n.compressedTexImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function rt(){try{n.texSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Ae(){try{n.texSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function Ft(){try{n.compressedTexSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Xe(){try{n.compressedTexSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function Ze(){try{n.texStorage2D(...arguments)}catch(F){it("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){it("WebGLState:",F)}}function b(){try{n.texImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function ue(F){return h[F]!==void 0?h[F]:n.getParameter(F)}function re(F,se){h[F]!==se&&(n.pixelStorei(F,se),h[F]=se)}function ye(F){j.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),j.copy(F))}function ve(F){pe.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),pe.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Te=te.get(F);Te===void 0&&(Te=n.getUniformBlockIndex(se,F.name),n.uniformBlockBinding(se,Te,Te),te.set(F,Te))}function ie(F,se,te){let xe=c.get(se).get(F);l[xe]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,te),l[xe]=te)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,ne={},f={},l={},d=new WeakMap,m=[],y=null,p=!1,g=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new ht(0,0,0),z=0,U=!1,D=null,H=null,O=null,I=null,V=null,j.set(0,0,n.canvas.width,n.canvas.height),pe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:ke,bindFramebuffer:st,drawBuffers:We,useProgram:fe,setBlending:Qe,setMaterial:mt,setFlipSided:wt,setCullFace:ct,setLineWidth:Xt,setPolygonOffset:ut,setScissorTest:Jt,activeTexture:qt,bindTexture:Mt,unbindTexture:N,compressedTexImage2D:Me,compressedTexImage3D:$e,texImage2D:b,texImage3D:X,pixelStorei:re,getParameter:ue,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:Ze,texStorage3D:R,texSubImage2D:rt,texSubImage3D:Ae,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Xe,scissor:ye,viewport:ve,reset:me}}function Cw(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new lt,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,y=new FinalizationRegistry(R=>m.delete(R)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,b){return p?new OffscreenCanvas(R,b):ko("canvas")}function v(R,b,X){let ue=1,re=Ze(R);if((re.width>X||re.height>X)&&(ue=X/Math.max(re.width,re.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(ue*re.width),ve=Math.floor(ue*re.height);f===void 0&&(f=g(ye,ve));let ee=b?g(ye,ve):f;return ee.width=ye,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,ye,ve),Ke("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+ye+"x"+ve+")."),ee}else return"data"in R&&Ke("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,b,X,ue,re,ye=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=b;if(b===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===n.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),b===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),b===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===n.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),b===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),b===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),b===n.RGB&&(X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===n.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),b===n.RGBA){let ie=ye?Oo:St.getTransfer(re);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ie===It?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===n.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function x(R,b){let X;return R?b===null||b===Ai||b===or?X=n.DEPTH24_STENCIL8:b===Ti?X=n.DEPTH32F_STENCIL8:b===so&&(X=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Ai||b===or?X=n.DEPTH_COMPONENT24:b===Ti?X=n.DEPTH_COMPONENT32F:b===so&&(X=n.DEPTH_COMPONENT16),X}function E(R,b){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==Sn&&R.minFilter!==En?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}function z(R){let b=new WeakRef(R);i.get(R).__ref=b,m.add(b),y.register(R,b,b)}function U(R){let b=i.get(R).__ref;b!==void 0&&(m.delete(b),y.unregister(b))}function D(R){O(R.target)}function H(R){I(R.target)}function O(R){R.removeEventListener("dispose",D),U(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function I(R){R.removeEventListener("dispose",H),U(R),ae(R)}function V(){for(let R of m){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):O(b))}m.clear(),h.clear()}function Y(R){let b=i.get(R);if(b.__webglInit===void 0)return;let X=R.source,ue=d.get(X);if(ue){let re=ue[b.__cacheKey];re.usedTimes--,re.usedTimes===0&&k(R),Object.keys(ue).length===0&&d.delete(X)}i.remove(R)}function k(R){let b=i.get(R);n.deleteTexture(b.__webglTexture);let X=R.source,ue=d.get(X);delete ue[b.__cacheKey],o.memory.textures--}function ae(R){let b=i.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&O(X),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(b.__webglFramebuffer[re]))for(let ye=0;ye<b.__webglFramebuffer[re].length;ye++)n.deleteFramebuffer(b.__webglFramebuffer[re][ye]);else n.deleteFramebuffer(b.__webglFramebuffer[re]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[re])}else{if(Array.isArray(b.__webglFramebuffer))for(let re=0;re<b.__webglFramebuffer.length;re++)n.deleteFramebuffer(b.__webglFramebuffer[re]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let re=0;re<b.__webglColorRenderbuffer.length;re++)b.__webglColorRenderbuffer[re]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[re]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ue=R.textures;for(let re=0,ye=ue.length;re<ye;re++){let ve=i.get(ue[re]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ue[re])}i.remove(R)}let $=0;function J(){$=0}function ne(){return $}function he(R){$=R}function ce(){let R=$;return R>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,R}function j(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}function pe(R,b){let X=i.get(R);if(R.isVideoTexture&&Ft(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ue=R.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{mt(X,R,b);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+b)}function ge(R,b){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){mt(X,R,b);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+b)}function _e(R,b){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){mt(X,R,b);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+b)}function Se(R,b){let X=i.get(R);if(R.version>0&&X.__version!==R.version){wt(X,R,b);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+b)}let ke={[Ml]:n.REPEAT,[zi]:n.CLAMP_TO_EDGE,[wl]:n.MIRRORED_REPEAT},st={[Sn]:n.NEAREST,[Um]:n.NEAREST_MIPMAP_NEAREST,[ea]:n.NEAREST_MIPMAP_LINEAR,[En]:n.LINEAR,[jl]:n.LINEAR_MIPMAP_NEAREST,[os]:n.LINEAR_MIPMAP_LINEAR},We={[km]:n.NEVER,[Wh]:n.ALWAYS,[zm]:n.LESS,[Gh]:n.LEQUAL,[Vm]:n.EQUAL,[Hh]:n.GEQUAL,[Gm]:n.GREATER,[Hm]:n.NOTEQUAL};function fe(R,b){if(b.type===Ti&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===En||b.magFilter===jl||b.magFilter===ea||b.magFilter===os||b.minFilter===En||b.minFilter===jl||b.minFilter===ea||b.minFilter===os)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,ke[b.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,ke[b.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,ke[b.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,st[b.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,st[b.minFilter]),b.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,We[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Sn||b.minFilter!==ea&&b.minFilter!==os||b.type===Ti&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function Le(R,b){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",D),z(b));let ue=b.source,re=d.get(ue);re===void 0&&(re={},d.set(ue,re));let ye=j(b);if(ye!==R.__cacheKey){re[ye]===void 0&&(re[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[ye].usedTimes++;let ve=re[R.__cacheKey];ve!==void 0&&(re[R.__cacheKey].usedTimes--,ve.usedTimes===0&&k(b)),R.__cacheKey=ye,R.__webglTexture=re[ye].texture}return X}function Ee(R,b,X){return Math.floor(Math.floor(R/X)/b)}function Qe(R,b,X,ue){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,X,ue,b.data);else{ye.sort((F,se)=>F.start-se.start);let ve=0;for(let F=1;F<ye.length;F++){let se=ye[ve],te=ye[F],Te=se.start+se.count,xe=Ee(te.start,b.width,4),we=Ee(se.start,b.width,4);te.start<=Te+1&&xe===we&&Ee(te.start+te.count-1,b.width,4)===xe?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,ye[ve]=te)}ye.length=ve+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let F=0,se=ye.length;F<se;F++){let te=ye[F],Te=Math.floor(te.start/4),xe=Math.ceil(te.count/4),we=Te%b.width,qe=Math.floor(Te/b.width),et=xe,le=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,we,qe,et,le,X,ue,b.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function mt(R,b,X){let ue=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ue=n.TEXTURE_3D);let re=Le(R,b),ye=b.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+X);let ve=i.get(ye);if(ye.version!==ve.__version||re===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let le=St.getPrimaries(St.workingColorSpace),Ve=b.colorSpace===ls?null:St.getPrimaries(b.colorSpace),tt=b.colorSpace===ls||le===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let ie=v(b.image,!1,s.maxTextureSize);ie=Xe(b,ie);let me=r.convert(b.format,b.colorSpace),F=r.convert(b.type),se=A(b.internalFormat,me,F,b.normalized,b.colorSpace,b.isVideoTexture);fe(ue,b);let te,Te=b.mipmaps,xe=b.isVideoTexture!==!0,we=ve.__version===void 0||re===!0,qe=ye.dataReady,et=E(b,ie);if(b.isDepthTexture)se=x(b.format===as,b.type),we&&(xe?t.texStorage2D(n.TEXTURE_2D,1,se,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,null));else if(b.isDataTexture)if(Te.length>0){xe&&we&&t.texStorage2D(n.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,Ve=Te.length;le<Ve;le++)te=Te[le],xe?qe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,me,F,te.data):t.texImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,me,F,te.data);b.generateMipmaps=!1}else xe?(we&&t.texStorage2D(n.TEXTURE_2D,et,se,ie.width,ie.height),qe&&Qe(b,ie,me,F)):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,ie.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){xe&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,se,Te[0].width,Te[0].height,ie.depth);for(let le=0,Ve=Te.length;le<Ve;le++)if(te=Te[le],b.format!==Ri)if(me!==null)if(xe){if(qe)if(b.layerUpdates.size>0){let tt=tf(te.width,te.height,b.format,b.type);for(let Ie of b.layerUpdates){let ft=te.data.subarray(Ie*tt/te.data.BYTES_PER_ELEMENT,(Ie+1)*tt/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,Ie,te.width,te.height,1,me,ft)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,me,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ie.depth,0,te.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,le,0,0,0,te.width,te.height,ie.depth,me,F,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,le,se,te.width,te.height,ie.depth,0,me,F,te.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{xe&&we&&t.texStorage2D(n.TEXTURE_2D,et,se,Te[0].width,Te[0].height);for(let le=0,Ve=Te.length;le<Ve;le++)te=Te[le],b.format!==Ri?me!==null?xe?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,me,te.data):t.compressedTexImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,te.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?qe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,te.width,te.height,me,F,te.data):t.texImage2D(n.TEXTURE_2D,le,se,te.width,te.height,0,me,F,te.data)}else if(b.isDataArrayTexture)if(xe){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,se,ie.width,ie.height,ie.depth),qe)if(b.layerUpdates.size>0){let le=tf(ie.width,ie.height,b.format,b.type);for(let Ve of b.layerUpdates){let tt=ie.data.subarray(Ve*le/ie.data.BYTES_PER_ELEMENT,(Ve+1)*le/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,ie.width,ie.height,1,me,F,tt)}b.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(b.isData3DTexture)xe?(we&&t.texStorage3D(n.TEXTURE_3D,et,se,ie.width,ie.height,ie.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(b.isFramebufferTexture){if(we)if(xe)t.texStorage2D(n.TEXTURE_2D,et,se,ie.width,ie.height);else{let le=ie.width,Ve=ie.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,se,le,Ve,0,me,F,null),le>>=1,Ve>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let le=n.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),ie.parentNode!==le){le.appendChild(ie),h.add(b),le.onpaint=Ve=>{let tt=Ve.changedElements;for(let Ie of h)tt.includes(Ie.image)&&(Ie.needsUpdate=!0)},le.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let tt=n.RGBA,Ie=n.RGBA,ft=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ie,ft,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&we){let le=Ze(Te[0]);t.texStorage2D(n.TEXTURE_2D,et,se,le.width,le.height)}for(let le=0,Ve=Te.length;le<Ve;le++)te=Te[le],xe?qe&&t.texSubImage2D(n.TEXTURE_2D,le,0,0,me,F,te):t.texImage2D(n.TEXTURE_2D,le,se,me,F,te);b.generateMipmaps=!1}else if(xe){if(we){let le=Ze(ie);t.texStorage2D(n.TEXTURE_2D,et,se,le.width,le.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,se,me,F,ie);T(b)&&b.mipmapsAutoUpdate===!0&&S(ue),ve.__version=ye.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function wt(R,b,X){if(b.image.length!==6)return;let ue=Le(R,b),re=b.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let ye=i.get(re);if(re.version!==ye.__version||ue===!0){t.activeTexture(n.TEXTURE0+X);let ve=St.getPrimaries(St.workingColorSpace),ee=b.colorSpace===ls?null:St.getPrimaries(b.colorSpace),ie=b.colorSpace===ls||ve===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=b.isCompressedTexture||b.image[0].isCompressedTexture,F=b.image[0]&&b.image[0].isDataTexture,se=[];for(let Ie=0;Ie<6;Ie++)!me&&!F?se[Ie]=v(b.image[Ie],!0,s.maxCubemapSize):se[Ie]=F?b.image[Ie].image:b.image[Ie],se[Ie]=Xe(b,se[Ie]);let te=se[0],Te=r.convert(b.format,b.colorSpace),xe=r.convert(b.type),we=A(b.internalFormat,Te,xe,b.normalized,b.colorSpace),qe=b.isVideoTexture!==!0,et=ye.__version===void 0||ue===!0,le=re.dataReady,Ve=E(b,te);fe(n.TEXTURE_CUBE_MAP,b);let tt;if(b.isDepthTexture){if(we=x(b.format===as,b.type),et)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,te.width,te.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,te.width,te.height,0,Te,xe,null)}else if(me){qe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,te.width,te.height);for(let Ie=0;Ie<6;Ie++){tt=se[Ie].mipmaps;for(let ft=0;ft<tt.length;ft++){let kt=tt[ft];b.format!==Ri?Te!==null?qe?le&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,0,0,kt.width,kt.height,Te,kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,we,kt.width,kt.height,0,kt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,0,0,kt.width,kt.height,Te,xe,kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft,we,kt.width,kt.height,0,Te,xe,kt.data)}}}else{if(tt=b.mipmaps,qe&&et){tt.length>0&&Ve++;let Ie=Ze(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(F){qe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,se[Ie].width,se[Ie].height,Te,xe,se[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,se[Ie].width,se[Ie].height,0,Te,xe,se[Ie].data);for(let ft=0;ft<tt.length;ft++){let In=tt[ft].image[Ie].image;qe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,0,0,In.width,In.height,Te,xe,In.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,we,In.width,In.height,0,Te,xe,In.data)}}else{qe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Te,xe,se[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,we,Te,xe,se[Ie]);for(let ft=0;ft<tt.length;ft++){let kt=tt[ft];qe?le&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,0,0,Te,xe,kt.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ft+1,we,Te,xe,kt.image[Ie])}}}T(b)&&b.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ye.__version=re.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function ct(R,b,X,ue,re,ye){let ve=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ie=A(X.internalFormat,ve,ee,X.normalized,X.colorSpace),me=i.get(b),F=i.get(X);if(F.__renderTarget=b,!me.__hasExternalTextures){let se=Math.max(1,b.width>>ye),te=Math.max(1,b.height>>ye);re===n.TEXTURE_3D||re===n.TEXTURE_2D_ARRAY?t.texImage3D(re,ye,ie,se,te,b.depth,0,ve,ee,null):t.texImage2D(re,ye,ie,se,te,0,ve,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Ae(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,re,F.__webglTexture,0,rt(b)):(re===n.TEXTURE_2D||re>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,re,F.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Xt(R,b,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),b.depthBuffer){let ue=b.depthTexture,re=ue&&ue.isDepthTexture?ue.type:null,ye=x(b.stencilBuffer,re),ve=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ae(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(b),ye,b.width,b.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(b),ye,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,ye,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let ue=b.textures;for(let re=0;re<ue.length;re++){let ye=ue[re],ve=r.convert(ye.format,ye.colorSpace),ee=r.convert(ye.type),ie=A(ye.internalFormat,ve,ee,ye.normalized,ye.colorSpace);Ae(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(b),ie,b.width,b.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(b),ie,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,ie,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ut(R,b,X){let ue=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(b.depthTexture);re.__renderTarget=b;let ye=ue?b.depthTexture.image[0]:b.depthTexture.image;(!re.__webglTexture||ye.width!==b.width||ye.height!==b.height)&&(ye.width=b.width,ye.height=b.height,b.depthTexture.needsUpdate=!0),ue?Se(b.depthTexture,0):pe(b.depthTexture,0);let ve=re.__webglTexture,ee=rt(b),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,me=b.depthTexture.format===as?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===ss)Ae(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ve,0);else if(b.depthTexture.format===as)Ae(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ve,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Jt(R){let b=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ue){let re=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ue.removeEventListener("dispose",re)};ue.addEventListener("dispose",re),b.__depthDisposeCallback=re}b.__boundDepthTexture=ue}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)ut(b.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?ut(b.__webglFramebuffer[0],R,0):ut(b.__webglFramebuffer,R,0);else if(X){b.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[ue]),b.__webglDepthbuffer[ue]===void 0)b.__webglDepthbuffer[ue]=n.createRenderbuffer(),Xt(b.__webglDepthbuffer[ue],R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),Xt(b.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function qt(R,b,X){let ue=i.get(R);b!==void 0&&ct(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&Jt(R)}function Mt(R){let b=R.texture,X=i.get(R),ue=i.get(b);R.addEventListener("dispose",H),z(R);let re=R.textures,ye=R.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=b.version,o.memory.textures++),ye){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(b.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<b.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<b.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ee=0,ie=re.length;ee<ie;ee++){let me=i.get(re[ee]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Ae(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ie=re[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let me=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),se=A(ie.internalFormat,me,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),te=rt(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Xt(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),fe(n.TEXTURE_CUBE_MAP,b);for(let ee=0;ee<6;ee++)if(b.mipmaps.length>0)for(let ie=0;ie<b.mipmaps.length;ie++)ct(X.__webglFramebuffer[ee][ie],R,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else ct(X.__webglFramebuffer[ee],R,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(b)?S(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ie=re.length;ee<ie;ee++){let me=re[ee],F=i.get(me),se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),fe(se,me),ct(X.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+ee,se,0),T(me)&&S(se)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ue.__webglTexture),fe(ee,b),b.mipmaps.length>0)for(let ie=0;ie<b.mipmaps.length;ie++)ct(X.__webglFramebuffer[ie],R,b,n.COLOR_ATTACHMENT0,ee,ie);else ct(X.__webglFramebuffer,R,b,n.COLOR_ATTACHMENT0,ee,0);T(b)?S(ee):b.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Jt(R)}function N(R){let b=R.textures;for(let X=0,ue=b.length;X<ue;X++){let re=b[X];if(T(re)&&re.mipmapsAutoUpdate===!0){let ye=C(R),ve=i.get(re).__webglTexture;t.bindTexture(ye,ve),S(ye),t.unbindTexture()}}}let Me=[];function $e(R){if(R.samples>0){if(Ae(R)===!1){let b=R.textures,X=R.width,ue=R.height,re=n.COLOR_BUFFER_BIT,ye=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),ee=b.length>1;if(ee)for(let me=0;me<b.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<b.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let F=i.get(b[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,ue,0,0,X,ue,re,n.NEAREST),l===!0&&(Me.length=0,Me.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Me.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Me))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let me=0;me<b.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let F=i.get(b[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let b=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function rt(R){return Math.min(s.maxSamples,R.samples)}function Ae(R){let b=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Ft(R){let b=o.render.frame;u.get(R)!==b&&(u.set(R,b),R.update())}function Xe(R,b){let X=R.colorSpace,ue=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Fo&&X!==ls&&(St.getTransfer(X)===It?(ue!==Ri||re!==ri)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",X)),b}function Ze(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=J,this.getTextureUnits=ne,this.setTextureUnits=he,this.setTexture2D=pe,this.setTexture2DArray=ge,this.setTexture3D=_e,this.setTextureCube=Se,this.rebindTextures=qt,this.setupRenderTarget=Mt,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=$e,this.setupDepthRenderbuffer=Jt,this.setupFrameBufferTexture=ct,this.useMultisampledRTT=Ae,this.dispose=V}function Rw(n,e){function t(i,s=ls){let r,o=St.getTransfer(s);if(i===ri)return n.UNSIGNED_BYTE;if(i===ec)return n.UNSIGNED_SHORT_4_4_4_4;if(i===tc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Fh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Oh)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Nh)return n.BYTE;if(i===Uh)return n.SHORT;if(i===so)return n.UNSIGNED_SHORT;if(i===Ql)return n.INT;if(i===Ai)return n.UNSIGNED_INT;if(i===Ti)return n.FLOAT;if(i===Ci)return n.HALF_FLOAT;if(i===Bh)return n.ALPHA;if(i===kh)return n.RGB;if(i===Ri)return n.RGBA;if(i===ss)return n.DEPTH_COMPONENT;if(i===as)return n.DEPTH_STENCIL;if(i===zh)return n.RED;if(i===nc)return n.RED_INTEGER;if(i===Ns)return n.RG;if(i===ic)return n.RG_INTEGER;if(i===sc)return n.RGBA_INTEGER;if(i===ta||i===na||i===ia||i===sa)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ta)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ta)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===na)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ia)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===sa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===rc||i===oc||i===ac||i===lc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===rc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ac)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===lc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===cc||i===uc||i===hc||i===fc||i===dc||i===ra||i===pc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===cc||i===uc)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===hc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===fc)return r.COMPRESSED_R11_EAC;if(i===dc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ra)return r.COMPRESSED_RG11_EAC;if(i===pc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===mc||i===gc||i===_c||i===xc||i===yc||i===vc||i===bc||i===Sc||i===Mc||i===wc||i===Ec||i===Ac||i===Tc||i===Cc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===mc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===gc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===_c)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===xc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===yc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===vc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===bc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Sc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Mc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===wc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Ec)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ac)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Tc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Cc)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Rc||i===Pc||i===Ic)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Rc)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Pc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ic)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Lc||i===Dc||i===oa||i===Nc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Lc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Dc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===oa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Nc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===or?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var Pw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Iw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,hf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new $o(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ii({vertexShader:Pw,fragmentShader:Iw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new di(new Zo(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ff=class extends wi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,y=typeof XRWebGLBinding<"u",p=new hf,g={},v=t.getContextAttributes(),T=null,S=null,C=[],A=[],x=new lt,E=null,z=null,U=new On;U.viewport=new Kt;let D=new On;D.viewport=new Kt;let H=[U,D],O=new Zl,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let pe=C[j];return pe===void 0&&(pe=new Jr,C[j]=pe),pe.getTargetRaySpace()},this.getControllerGrip=function(j){let pe=C[j];return pe===void 0&&(pe=new Jr,C[j]=pe),pe.getGripSpace()},this.getHand=function(j){let pe=C[j];return pe===void 0&&(pe=new Jr,C[j]=pe),pe.getHandSpace()};function Y(j){let pe=A.indexOf(j.inputSource);if(pe===-1)return;let ge=C[pe];ge!==void 0&&(ge.update(j.inputSource,j.frame,c||o),ge.dispatchEvent({type:j.type,data:j.inputSource}))}function k(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",ae);for(let j=0;j<C.length;j++){let pe=A[j];pe!==null&&(A[j]=null,C[j].disconnect(pe))}I=null,V=null,p.reset();for(let j in g)delete g[j];if(e.setRenderTarget(T),d=null,f=null,h=null,s=null,S=null,ce.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),z!==null){let j=z.camera;j.fov=z.fov,j.zoom=z.zoom,j.updateProjectionMatrix(),z=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",k),s.addEventListener("inputsourceschange",ae),v.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,_e=null,Se=null;v.depth&&(Se=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?as:ss,_e=v.stencil?or:Ai);let ke={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(ke),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new ti(f.textureWidth,f.textureHeight,{format:Ri,type:ri,depthTexture:new rs(f.textureWidth,f.textureHeight,_e,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new ti(d.framebufferWidth,d.framebufferHeight,{format:Ri,type:ri,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ae(j){for(let pe=0;pe<j.removed.length;pe++){let ge=j.removed[pe],_e=A.indexOf(ge);_e>=0&&(A[_e]=null,C[_e].disconnect(ge))}for(let pe=0;pe<j.added.length;pe++){let ge=j.added[pe],_e=A.indexOf(ge);if(_e===-1){for(let ke=0;ke<C.length;ke++)if(ke>=A.length){A.push(ge),_e=ke;break}else if(A[ke]===null){A[ke]=ge,_e=ke;break}if(_e===-1)break}let Se=C[_e];Se&&Se.connect(ge)}}function $(j,pe){pe===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(pe.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let pe=j.near,ge=j.far;p.texture!==null&&(p.depthNear>0&&(pe=p.depthNear),p.depthFar>0&&(ge=p.depthFar)),O.near=D.near=U.near=pe,O.far=D.far=U.far=ge,(I!==O.near||V!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),I=O.near,V=O.far),O.layers.mask=j.layers.mask|6,U.layers.mask=O.layers.mask&-5,D.layers.mask=O.layers.mask&-3;let _e=j.parent,Se=O.cameras;$(O,_e);for(let ke=0;ke<Se.length;ke++)$(Se[ke],_e);O.projectionMatrix.copy(U.projectionMatrix),O.projectionMatrixInverse.copy(U.projectionMatrixInverse),z===null&&j.isPerspectiveCamera&&(z={camera:j,fov:j.fov,zoom:j.zoom}),J(j,O,_e)};function J(j,pe,ge){ge===null?j.matrix.copy(pe.matrixWorld):(j.matrix.copy(ge.matrixWorld),j.matrix.invert(),j.matrix.multiply(pe.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(pe.projectionMatrix),j.projectionMatrixInverse.copy(pe.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=Zr*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(O)},this.getCameraTexture=function(j){return g[j]};let ne=null;function he(j,pe){if(u=pe.getViewerPose(c||o),m=pe,u!==null){let ge=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let _e=!1;ge.length!==O.cameras.length&&(O.cameras.length=0,_e=!0);for(let We=0;We<ge.length;We++){let fe=ge[We],Le=null;if(d!==null)Le=d.getViewport(fe);else{let Qe=h.getViewSubImage(f,fe);Le=Qe.viewport,We===0&&(e.setRenderTargetTextures(S,Qe.colorTexture,Qe.depthStencilTexture),e.setRenderTarget(S))}let Ee=H[We];Ee===void 0&&(Ee=new On,Ee.layers.enable(We),Ee.viewport=new Kt,H[We]=Ee),Ee.matrix.fromArray(fe.transform.matrix),Ee.matrix.decompose(Ee.position,Ee.quaternion,Ee.scale),Ee.projectionMatrix.fromArray(fe.projectionMatrix),Ee.projectionMatrixInverse.copy(Ee.projectionMatrix).invert(),Ee.viewport.set(Le.x,Le.y,Le.width,Le.height),We===0&&(O.matrix.copy(Ee.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),_e===!0&&O.cameras.push(Ee)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let We=h.getDepthInformation(ge[0]);We&&We.isValid&&We.texture&&p.init(We,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let We=0;We<ge.length;We++){let fe=ge[We].camera;if(fe){let Le=g[fe];Le||(Le=new $o,g[fe]=Le);let Ee=h.getCameraImage(fe);Le.sourceTexture=Ee}}}}for(let ge=0;ge<C.length;ge++){let _e=A[ge],Se=C[ge];_e!==null&&Se!==void 0&&Se.update(_e,pe,c||o)}ne&&ne(j,pe),pe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:pe}),m=null}let ce=new Sg;ce.setAnimationLoop(he),this.setAnimationLoop=function(j){ne=j},this.dispose=function(){}}},Lw=new Zt,Lg=new ot;Lg.set(-1,0,0,0,1,0,0,0,1);function Dw(n,e){function t(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function i(p,g){g.color.getRGB(p.fogColor.value,jh(n)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,v,T,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),h(p,g)):g.isMeshPhongMaterial?(r(p,g),u(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),f(p,g),g.isMeshPhysicalMaterial&&d(p,g,S)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),y(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,v,T):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,t(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===kn&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,t(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===kn&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,t(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,t(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let v=e.get(g),T=v.envMap,S=v.envMapRotation;T&&(p.envMap.value=T,p.envMapRotation.value.setFromMatrix4(Lw.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Lg),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,v,T){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*v,p.scale.value=T*.5,g.map&&(p.map.value=g.map,t(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function u(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function h(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function f(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function d(p,g,v){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===kn&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function y(p,g){let v=e.get(g).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Nw(n,e,t,i){let s={},r={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(m(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",p));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let T=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,x=S.length;A<x;A++){let E=S[A];if(Array.isArray(E))for(let z=0,U=E.length;z<U;z++)u(E[z],A,z,C);else u(E,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,T,S,C){if(f(v,T,S,C)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let E=0;for(let z=0;z<x.length;z++){let U=x[z],D=y(U,!0);h(U,v.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function h(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function f(v,T,S,C){let A=v.value,x=T+"_"+S;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let E=C[x],z=!1;for(let U=0;U<A.length;U++)d(A[U],E,U)===!0&&(z=!0);return z}return d(A,C,x)}function d(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function m(v){let T=v.uniforms,S=0,C=16;for(let x=0,E=T.length;x<E;x++){let z=Array.isArray(T[x])?T[x]:[T[x]];for(let U=0,D=z.length;U<D;U++){let H=z[U],O=Array.isArray(H.value)?H.value:[H.value],I=Array.isArray(T[x])||Array.isArray(H.value),V=S;for(let k=0,ae=O.length;k<ae;k++){let $=O[k],J=y($,I),ne=S%C,he=ne%J.boundary,ce=ne+he;S+=he,ce!==0&&C-ce<J.storage&&(S+=C-ce),k===0&&(V=S),S+=J.storage}let Y=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new Y((S-V)/Float32Array.BYTES_PER_ELEMENT),H.__offset=V}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function y(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(v){let T=v.target;T.removeEventListener("dispose",p),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var Uw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Gi=null;function Fw(){return Gi===null&&(Gi=new jr(Uw,16,16,Ns,Ci),Gi.name="DFG_LUT",Gi.minFilter=En,Gi.magFilter=En,Gi.wrapS=zi,Gi.wrapT=zi,Gi.generateMipmaps=!1,Gi.needsUpdate=!0),Gi}var Bc=class{constructor(e={}){let{canvas:t=Xm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=ri}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let y=d,p=new Set([sc,ic,nc]),g=new Set([ri,Ai,so,or,ec,tc]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],E=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Vi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,H=null,O=null,I=null,V=null;this._outputColorSpace=jn;let Y=0,k=0,ae=null,$=-1,J=null,ne=new Kt,he=new Kt,ce=null,j=new ht(0),pe=0,ge=t.width,_e=t.height,Se=1,ke=null,st=null,We=new Kt(0,0,ge,_e),fe=new Kt(0,0,ge,_e),Le=!1,Ee=new nr,Qe=new Pl,mt=!1,wt=!1,ct=new Zt,Xt=new W,ut=new Kt,Jt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},qt=!1;function Mt(){return ae===null?Se:1}let N=i;function Me(w,B){return t.getContext(w,B)}let $e,rt,Ae,Ft,Xe,Ze,R,b,X,ue,re,ye,ve,ee,ie,me,F,se,te,Te,xe,we,qe;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),N===null){let B="webgl2";if(N=Me(B,w),N===null)throw Me(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(w){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),it("WebGLRenderer: "+w.message),w}function et(){$e=new YS(N),$e.init(),xe=new Rw(N,$e),rt=new FS(N,$e,e,xe),Ae=new Tw(N,$e),rt.reversedDepthBuffer&&f&&Ae.buffers.depth.setReversed(!0),O=N.createFramebuffer(),I=N.createFramebuffer(),V=N.createFramebuffer(),Ft=new KS(N),Xe=new dw,Ze=new Cw(N,$e,Ae,Xe,rt,xe,Ft),R=new qS(U),b=new jy(N),we=new NS(N,b),X=new $S(N,b,Ft,we),ue=new jS(N,X,b,we,Ft),se=new JS(N,rt,Ze),ie=new OS(Xe),re=new fw(U,R,$e,rt,we,ie),ye=new Dw(U,Xe),ve=new mw,ee=new bw($e),F=new DS(U,R,Ae,ue,m,l),me=new Aw(U,ue,rt),qe=new Nw(N,Ft,rt,Ae),te=new US(N,$e,Ft),Te=new ZS(N,$e,Ft),Ft.programs=re.programs,U.capabilities=rt,U.extensions=$e,U.properties=Xe,U.renderLists=ve,U.shadowMap=me,U.state=Ae,U.info=Ft}y!==ri&&(z=new eM(y,t.width,t.height,a,s,r));let le=new ff(U,N);this.xr=le,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let w=$e.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=$e.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(w){w!==void 0&&(Se=w,this.setSize(ge,_e,!1))},this.getSize=function(w){return w.set(ge,_e)},this.setSize=function(w,B,Q=!0){if(le.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=w,_e=B,t.width=Math.floor(w*Se),t.height=Math.floor(B*Se),Q===!0&&(t.style.width=w+"px",t.style.height=B+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,w,B)},this.getDrawingBufferSize=function(w){return w.set(ge*Se,_e*Se).floor()},this.setDrawingBufferSize=function(w,B,Q){ge=w,_e=B,Se=Q,t.width=Math.floor(w*Q),t.height=Math.floor(B*Q),this.setViewport(0,0,w,B)},this.setEffects=function(w){if(y===ri){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let B=0;B<w.length;B++)if(w[B].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ne)},this.getViewport=function(w){return w.copy(We)},this.setViewport=function(w,B,Q,q){w.isVector4?We.set(w.x,w.y,w.z,w.w):We.set(w,B,Q,q),Ae.viewport(ne.copy(We).multiplyScalar(Mt()).round())},this.getScissor=function(w){return w.copy(fe)},this.setScissor=function(w,B,Q,q){w.isVector4?fe.set(w.x,w.y,w.z,w.w):fe.set(w,B,Q,q),Ae.scissor(he.copy(fe).multiplyScalar(Mt()).round())},this.getScissorTest=function(){return Le},this.setScissorTest=function(w){Ae.setScissorTest(Le=w)},this.setOpaqueSort=function(w){ke=w},this.setTransparentSort=function(w){st=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,B=!0,Q=!0){let q=0;if(w){let Z=!1;if(ae!==null){let Ce=ae.texture.format;Z=p.has(Ce)}if(Z){let Ce=ae.texture.type,De=g.has(Ce),Re=F.getClearColor(),Ne=F.getClearAlpha(),He=Re.r,nt=Re.g,gt=Re.b;De?(v[0]=He,v[1]=nt,v[2]=gt,v[3]=Ne,N.clearBufferuiv(N.COLOR,0,v)):(T[0]=He,T[1]=nt,T[2]=gt,T[3]=Ne,N.clearBufferiv(N.COLOR,0,T))}else q|=N.COLOR_BUFFER_BIT}B&&(q|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(q|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&N.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),H=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),F.dispose(),ve.dispose(),ee.dispose(),Ze.dispose(),Xe.dispose(),R.dispose(),ue.dispose(),X.dispose(),we.dispose(),qe.dispose(),re.dispose(),le.dispose(),le.removeEventListener("sessionstart",_a),le.removeEventListener("sessionend",Pi),Wi.stop()};function Ve(w){w.preventDefault(),Yh("WebGLRenderer: Context Lost."),D=!0}function tt(){Yh("WebGLRenderer: Context Restored."),D=!1;let w=Ft.autoReset,B=me.enabled,Q=me.autoUpdate,q=me.needsUpdate,Z=me.type;et(),Ft.autoReset=w,me.enabled=B,me.autoUpdate=Q,me.needsUpdate=q,me.type=Z}function Ie(w){it("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function ft(w){let B=w.target;B.removeEventListener("dispose",ft),kt(B)}function kt(w){In(w),Xe.remove(w)}function In(w){let B=Xe.get(w).programs;B!==void 0&&(B.forEach(function(Q){re.releaseProgram(Q)}),w.isShaderMaterial&&re.releaseShaderCache(w))}this.renderBufferDirect=function(w,B,Q,q,Z,Ce){B===null&&(B=Jt);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Re=po(w,B,Q,q,Z);Ae.setMaterial(q,De);let Ne=Q.index,He=1;if(q.wireframe===!0){if(Ne=X.getWireframeAttribute(Q),Ne===void 0)return;He=2}let nt=Q.drawRange,gt=Q.attributes.position,Ge=nt.start*He,_t=(nt.start+nt.count)*He;Ce!==null&&(Ge=Math.max(Ge,Ce.start*He),_t=Math.min(_t,(Ce.start+Ce.count)*He)),Ne!==null?(Ge=Math.max(Ge,0),_t=Math.min(_t,Ne.count)):gt!=null&&(Ge=Math.max(Ge,0),_t=Math.min(_t,gt.count));let $t=_t-Ge;if($t<0||$t===1/0)return;we.setup(Z,q,Re,Q,Ne);let Lt,Dt=te;if(Ne!==null&&(Lt=b.get(Ne),Dt=Te,Dt.setIndex(Lt)),Z.isMesh)q.wireframe===!0?(Ae.setLineWidth(q.wireframeLinewidth*Mt()),Dt.setMode(N.LINES)):Dt.setMode(N.TRIANGLES);else if(Z.isLine){let hn=q.linewidth;hn===void 0&&(hn=1),Ae.setLineWidth(hn*Mt()),Z.isLineSegments?Dt.setMode(N.LINES):Z.isLineLoop?Dt.setMode(N.LINE_LOOP):Dt.setMode(N.LINE_STRIP)}else Z.isPoints?Dt.setMode(N.POINTS):Z.isSprite&&Dt.setMode(N.TRIANGLES);if(Z.isBatchedMesh)if($e.get("WEBGL_multi_draw"))Dt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let hn=Z._multiDrawStarts,Be=Z._multiDrawCounts,rn=Z._multiDrawCount,vt=Ne?b.get(Ne).bytesPerElement:1,qi=Xe.get(q).currentProgram.getUniforms();for(let on=0;on<rn;on++)qi.setValue(N,"_gl_DrawID",on),Dt.render(hn[on]/vt,Be[on])}else if(Z.isInstancedMesh)Dt.renderInstances(Ge,$t,Z.count);else if(Q.isInstancedBufferGeometry){let hn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Be=Math.min(Q.instanceCount,hn);Dt.renderInstances(Ge,$t,Be)}else Dt.render(Ge,$t)};function uo(w,B,Q,q){H!==null&&w.isNodeMaterial&&H.setObject(q,w),mt===!0&&ie.setState(w,Q,!1),w.transparent===!0&&w.side===pi&&w.forceSinglePass===!1?(w.side=kn,w.needsUpdate=!0,Ii(w,B,q),w.side=Ds,w.needsUpdate=!0,Ii(w,B,q),w.side=pi):Ii(w,B,q)}this.compile=function(w,B,Q=null){Q===null&&(Q=w),H!==null&&H.renderStart(w,B,Q),A=ee.get(Q),A.init(B),E.push(A),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),w!==Q&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),H!==null&&H.updateLights(A.state.lightsArray),wt=this.localClippingEnabled,mt=ie.init(this.clippingPlanes,wt),mt===!0&&ie.setGlobalState(this.clippingPlanes,B),H!==null&&me.render(A.state.shadowsArray,Q,B);let q=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ce=Z.material;if(Ce)if(Array.isArray(Ce))for(let De=0;De<Ce.length;De++){let Re=Ce[De];uo(Re,Q,B,Z),q.add(Re)}else uo(Ce,Q,B,Z),q.add(Ce)}),A=E.pop(),H!==null&&H.renderEnd(),q},this.compileAsync=function(w,B,Q=null){let q=this.compile(w,B,Q);return new Promise(Z=>{function Ce(){if(q.forEach(function(De){let Ne=Xe.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&q.delete(De)}),q.size===0){Z(w);return}setTimeout(Ce,10)}$e.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let cr=null;function eu(w){cr&&cr(w)}function _a(){Wi.stop()}function Pi(){Wi.start()}let Wi=new Sg;Wi.setAnimationLoop(eu),typeof self<"u"&&Wi.setContext(self),this.setAnimationLoop=function(w){cr=w,le.setAnimationLoop(w),w===null?Wi.stop():Wi.start()},le.addEventListener("sessionstart",_a),le.addEventListener("sessionend",Pi),this.render=function(w,B){if(B!==void 0&&B.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(w,B);let Q=le.enabled===!0&&le.isPresenting===!0,q=z!==null&&(ae===null||Q)&&z.begin(U,ae);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(B),B=le.getCamera()),w.isScene===!0&&w.onBeforeRender(U,w,B,ae),A=ee.get(w,E.length),A.init(B),A.state.textureUnits=Ze.getTextureUnits(),E.push(A),ct.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Qe.setFromArrayCamera(B):Ee.setFromProjectionMatrix(ct,fi,B.reversedDepth),wt=this.localClippingEnabled,mt=ie.init(this.clippingPlanes,wt),C=ve.get(w,x.length),C.init(),x.push(C),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let De=U.xr.getDepthSensingMesh();De!==null&&Xi(De,B,-1/0,U.sortObjects)}Xi(w,B,0,U.sortObjects),C.finish(),H!==null&&H.updateLights(A.state.lightsArray),U.sortObjects===!0&&C.sort(ke,st),qt=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,qt&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),mt===!0&&ie.beginShadows();let Z=A.state.shadowsArray;if(me.render(Z,w,B),mt===!0&&ie.endShadows(),(q&&z.hasRenderPass())===!1){let De=C.opaque,Re=C.transmissive;if(A.setupLights(),B.isArrayCamera){let Ne=B.cameras;if(Re.length>0)for(let He=0,nt=Ne.length;He<nt;He++){let gt=Ne[He];mi(De,Re,w,gt)}qt&&F.render(w);for(let He=0,nt=Ne.length;He<nt;He++){let gt=Ne[He];ho(C,w,gt,gt.viewport)}}else Re.length>0&&mi(De,Re,w,B),qt&&F.render(w),ho(C,w,B)}ae!==null&&k===0&&(Ze.updateMultisampleRenderTarget(ae),Ze.updateRenderTargetMipmap(ae)),q&&z.end(U),w.isScene===!0&&w.onAfterRender(U,w,B),we.resetDefaultState(),$=-1,J=null,E.pop(),E.length>0?(A=E[E.length-1],Ze.setTextureUnits(A.state.textureUnits),mt===!0&&ie.setGlobalState(U.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,H!==null&&H.renderEnd()};function Xi(w,B,Q,q){if(w.visible===!1)return;if(w.layers.test(B.layers)){if(w.isGroup)Q=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(B);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let De=B.isArrayCamera?Qe:Ee;if(!w.frustumCulled||w.intersectsFrustum(De)){q&&ut.setFromMatrixPosition(w.matrixWorld).applyMatrix4(ct);let Re=ue.update(w),Ne=w.material;Ne.visible&&C.push(w,Re,Ne,Q,ut.z,null,B)}}else if(w.isMesh||w.isLine||w.isPoints){let De=B.isArrayCamera?Qe:Ee;if(!w.frustumCulled||w.intersectsFrustum(De)){let Re=ue.update(w),Ne=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),ut.copy(w.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),ut.copy(Re.boundingSphere.center)),ut.applyMatrix4(w.matrixWorld).applyMatrix4(ct)),Array.isArray(Ne)){let He=Re.groups;for(let nt=0,gt=He.length;nt<gt;nt++){let Ge=He[nt],_t=Ne[Ge.materialIndex];_t&&_t.visible&&C.push(w,Re,_t,Q,ut.z,Ge,B)}}else Ne.visible&&C.push(w,Re,Ne,Q,ut.z,null,B)}}}let Ce=w.children;for(let De=0,Re=Ce.length;De<Re;De++)Xi(Ce[De],B,Q,q)}function ho(w,B,Q,q){let{opaque:Z,transmissive:Ce,transparent:De}=w;A.setupLightsView(Q),mt===!0&&ie.setGlobalState(U.clippingPlanes,Q),q&&Ae.viewport(ne.copy(q)),Z.length>0&&jt(Z,B,Q),Ce.length>0&&jt(Ce,B,Q),De.length>0&&jt(De,B,Q),Ae.buffers.depth.setTest(!0),Ae.buffers.depth.setMask(!0),Ae.buffers.color.setMask(!0),Ae.setPolygonOffset(!1)}function mi(w,B,Q,q){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[q.id]===void 0){let Ge=$e.has("EXT_color_buffer_half_float")||$e.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[q.id]=new ti(1,1,{generateMipmaps:!0,type:Ge?Ci:ri,minFilter:os,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ce=A.state.transmissionRenderTarget[q.id],De=q.viewport||ne;Ce.setSize(De.z*U.transmissionResolutionScale,De.w*U.transmissionResolutionScale);let Re=U.getRenderTarget(),Ne=U.getActiveCubeFace(),He=U.getActiveMipmapLevel();U.setRenderTarget(Ce),U.getClearColor(j),pe=U.getClearAlpha(),pe<1&&U.setClearColor(16777215,.5),U.clear(),qt&&F.render(Q);let nt=U.toneMapping;U.toneMapping=Vi;let gt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),A.setupLightsView(q),mt===!0&&ie.setGlobalState(U.clippingPlanes,q),jt(w,Q,q),Ze.updateMultisampleRenderTarget(Ce),Ze.updateRenderTargetMipmap(Ce),$e.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let _t=0,$t=B.length;_t<$t;_t++){let Lt=B[_t],{object:Dt,geometry:hn,material:Be,group:rn}=Lt;if(Be.side===pi&&Dt.layers.test(q.layers)){let vt=Be.side;Be.side=kn,Be.needsUpdate=!0,nn(Dt,Q,q,hn,Be,rn),Be.side=vt,Be.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Ce),Ze.updateRenderTargetMipmap(Ce))}U.setRenderTarget(Re,Ne,He),U.setClearColor(j,pe),gt!==void 0&&(q.viewport=gt),U.toneMapping=nt}function jt(w,B,Q){let q=B.isScene===!0?B.overrideMaterial:null;for(let Z=0,Ce=w.length;Z<Ce;Z++){let De=w[Z],{object:Re,geometry:Ne,group:He}=De,nt=De.material;nt.allowOverride===!0&&q!==null&&(nt=q),Re.layers.test(Q.layers)&&nn(Re,B,Q,Ne,nt,He)}}function nn(w,B,Q,q,Z,Ce){H!==null&&Z.isNodeMaterial&&H.setObject(w,Z),w.onBeforeRender(U,B,Q,q,Z,Ce),w.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(U,B,Q,q,w,Ce),Z.transparent===!0&&Z.side===pi&&Z.forceSinglePass===!1?(Z.side=kn,Z.needsUpdate=!0,U.renderBufferDirect(Q,B,q,Z,w,Ce),Z.side=Ds,Z.needsUpdate=!0,U.renderBufferDirect(Q,B,q,Z,w,Ce),Z.side=pi):U.renderBufferDirect(Q,B,q,Z,w,Ce),w.onAfterRender(U,B,Q,q,Z,Ce)}function sn(w){let B=0;for(let Q of w)Q.texture!==null&&B++;return B}function Ii(w,B,Q){B.isScene!==!0&&(B=Jt);let q=Xe.get(w),Z=A.state.lights,Ce=A.state.shadowsArray,De=Z.state.version,Re=re.getParameters(w,Z.state,Ce,B,Q,A.state.lightProbeGridArray),Ne=re.getProgramCacheKey(Re),He=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?B.environment:null,q.fog=B.fog;let nt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=R.get(w.envMap||q.environment,nt),q.envMapRotation=q.environment!==null&&w.envMap===null?B.environmentRotation:w.envMapRotation,He===void 0&&(w.addEventListener("dispose",ft),He=new Map,q.programs=He,q.programVariants=new Map);let gt=He.get(Ne);if(gt!==void 0){if(q.currentProgram===gt&&q.lightsStateVersion===De)return fo(w,Re),gt}else Re.uniforms=re.getUniforms(w),H!==null&&w.isNodeMaterial&&H.build(w,Q,Re),w.onBeforeCompile(Re,U),gt=re.acquireProgram(Re,Ne),He.set(Ne,gt),q.uniforms=Re.uniforms;let Ge=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ge.clippingPlanes=ie.uniform),fo(w,Re),q.needsLights=hs(w),q.lightsStateVersion=De,q.needsLights&&(Ge.ambientLightColor.value=Z.state.ambient,Ge.lightProbe.value=Z.state.probe,Ge.sunLights.value=Z.state.sun,Ge.sunLightShadows.value=Z.state.sunShadow,Ge.directionalLights.value=Z.state.directional,Ge.directionalLightShadows.value=Z.state.directionalShadow,Ge.spotLights.value=Z.state.spot,Ge.spotLightShadows.value=Z.state.spotShadow,Ge.rectAreaLights.value=Z.state.rectArea,Ge.ltc_1.value=Z.state.rectAreaLTC1,Ge.ltc_2.value=Z.state.rectAreaLTC2,Ge.pointLights.value=Z.state.point,Ge.pointLightShadows.value=Z.state.pointShadow,Ge.hemisphereLights.value=Z.state.hemi,Ge.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ge.sunShadowCascade.value=Z.state.sunShadowCascade,Ge.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ge.spotLightMatrix.value=Z.state.spotLightMatrix,Ge.spotLightMap.value=Z.state.spotLightMap,Ge.pointShadowMatrix.value=Z.state.pointShadowMatrix),q.numLightProbeGrids=sn(A.state.lightProbeGridArray),q.currentProgram=gt,q.uniformsList=null,gt}function Hn(w,B,Q,q,Z){let Ce=Xe.get(w),De=Ce.currentProgram.id+","+q+","+Z,Re=Ce.programVariants.get(De);return Re===void 0?(Re=Ii(w,B,Q),Ce.programVariants.set(De,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=q,Ce.toneMapping=Z),Re}function us(w){if(w.uniformsList===null){let B=w.currentProgram.getUniforms();w.uniformsList=oo.seqWithValue(B.seq,w.uniforms)}return w.uniformsList}function fo(w,B){let Q=Xe.get(w);Q.outputColorSpace=B.outputColorSpace,Q.batching=B.batching,Q.batchingColor=B.batchingColor,Q.instancing=B.instancing,Q.instancingColor=B.instancingColor,Q.instancingMorph=B.instancingMorph,Q.skinning=B.skinning,Q.morphTargets=B.morphTargets,Q.morphNormals=B.morphNormals,Q.morphColors=B.morphColors,Q.morphTargetsCount=B.morphTargetsCount,Q.numClippingPlanes=B.numClippingPlanes,Q.numIntersection=B.numClipIntersection,Q.vertexAlphas=B.vertexAlphas,Q.vertexTangents=B.vertexTangents,Q.toneMapping=B.toneMapping}function po(w,B,Q,q,Z){B.isScene!==!0&&(B=Jt),Ze.resetTextureUnits();let Ce=B.fog,De=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?B.environment:null,Re=ae===null?U.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:St.workingColorSpace,Ne=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,He=R.get(q.envMap||De,Ne),nt=q.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,gt=!!Q.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),Ge=!!Q.morphAttributes.position,_t=!!Q.morphAttributes.normal,$t=!!Q.morphAttributes.color,Lt=Vi;q.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Lt=U.toneMapping);let Dt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,hn=Dt!==void 0?Dt.length:0,Be=Xe.get(q),rn=A.state.lights;if(mt===!0&&(wt===!0||w!==J)){let Nt=w===J&&q.id===$;ie.setState(q,w,Nt)}let vt=!1,qi=!1;q.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==rn.state.version||Z.isBatchedMesh&&Be.batching===!1||!Z.isBatchedMesh&&Be.batching===!0||Z.isBatchedMesh&&Be.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Be.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Be.instancing===!1||!Z.isInstancedMesh&&Be.instancing===!0||Z.isSkinnedMesh&&Be.skinning===!1||!Z.isSkinnedMesh&&Be.skinning===!0||Z.isInstancedMesh&&Be.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Be.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Be.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Be.instancingMorph===!1&&Z.morphTexture!==null||Be.envMap!==He||q.fog===!0&&Be.fog!==Ce||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==ie.numPlanes||Be.numIntersection!==ie.numIntersection)||Be.vertexAlphas!==nt||Be.vertexTangents!==gt||Be.morphTargets!==Ge||Be.morphNormals!==_t||Be.morphColors!==$t||Be.morphTargetsCount!==hn||Be.numLightProbeGrids!==sn(A.state.lightProbeGridArray)?vt=!0:(Be.outputColorSpace!==Re||Be.toneMapping!==Lt)&&(qi=!0):(vt=!0,Be.__version=q.version);let on=Be.currentProgram;(vt===!0||qi===!0)&&(on=qi===!0?Hn(q,B,Z,Re,Lt):Ii(q,B,Z),H&&q.isNodeMaterial&&H.onUpdateProgram(q,on,Be));let fr=!1,Li=!1,Yi=!1,dt=on.getUniforms(),Qt=Be.uniforms;if(Ae.useProgram(on.program)&&(fr=!0,Li=!0,Yi=!0),q.id!==$&&($=q.id,Li=!0),fr||J!==w){Ae.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),dt.setValue(N,"projectionMatrix",w.projectionMatrix),dt.setValue(N,"viewMatrix",w.matrixWorldInverse);let an=dt.map.cameraPosition;an!==void 0&&an.setValue(N,Xt.setFromMatrixPosition(w.matrixWorld)),rt.logarithmicDepthBuffer&&dt.setValue(N,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&dt.setValue(N,"isOrthographic",w.isOrthographicCamera===!0),J!==w&&(J=w,Li=!0,Yi=!0)}if(Be.needsLights&&(rn.state.sunShadowMap.length>0&&dt.setValue(N,"sunShadowMap",rn.state.sunShadowMap,Ze),rn.state.directionalShadowMap.length>0&&dt.setValue(N,"directionalShadowMap",rn.state.directionalShadowMap,Ze),rn.state.spotShadowMap.length>0&&dt.setValue(N,"spotShadowMap",rn.state.spotShadowMap,Ze),rn.state.pointShadowMap.length>0&&dt.setValue(N,"pointShadowMap",rn.state.pointShadowMap,Ze)),Z.isSkinnedMesh){dt.setOptional(N,Z,"bindMatrix"),dt.setOptional(N,Z,"bindMatrixInverse");let Nt=Z.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),dt.setValue(N,"boneTexture",Nt.boneTexture,Ze))}Z.isBatchedMesh&&(dt.setOptional(N,Z,"batchingTexture"),dt.setValue(N,"batchingTexture",Z._matricesTexture,Ze),dt.setOptional(N,Z,"batchingIdTexture"),dt.setValue(N,"batchingIdTexture",Z._indirectTexture,Ze),dt.setOptional(N,Z,"batchingColorTexture"),Z._colorsTexture!==null&&dt.setValue(N,"batchingColorTexture",Z._colorsTexture,Ze));let Ln=Q.morphAttributes;if((Ln.position!==void 0||Ln.normal!==void 0||Ln.color!==void 0)&&se.update(Z,Q,on),(Li||Be.receiveShadow!==Z.receiveShadow)&&(Be.receiveShadow=Z.receiveShadow,dt.setValue(N,"receiveShadow",Z.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&B.environment!==null&&(Qt.envMapIntensity.value=B.environmentIntensity),Qt.dfgLUT!==void 0&&(Qt.dfgLUT.value=Fw()),Li){if(dt.setValue(N,"toneMappingExposure",U.toneMappingExposure),Be.needsLights&&ur(Qt,Yi),Ce&&q.fog===!0&&ye.refreshFogUniforms(Qt,Ce),ye.refreshMaterialUniforms(Qt,q,Se,_e,A.state.transmissionRenderTarget[w.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Nt=S,an=0;for(let An of A.state.lightProbeGridArray)An.texture!==null&&(Nt.textures[an]=An.texture,Nt.min[an]=An.boundingBox.min,Nt.max[an]=An.boundingBox.max,Nt.resolution[an]=An.resolution,an++);for(let An in Nt)Nt[An].length=an;Qt.probesSH.value=Nt.textures,Qt.probesMin.value=Nt.min,Qt.probesMax.value=Nt.max,Qt.probesResolution.value=Nt.resolution}oo.upload(N,us(Be),Qt,Ze)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(oo.upload(N,us(Be),Qt,Ze),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&dt.setValue(N,"center",Z.center),dt.setValue(N,"modelViewMatrix",Z.modelViewMatrix),dt.setValue(N,"normalMatrix",Z.normalMatrix),dt.setValue(N,"modelMatrix",Z.matrixWorld),q.uniformsGroups!==void 0){let Nt=q.uniformsGroups;for(let an=0,An=Nt.length;an<An;an++){let xa=Nt[an];qe.update(xa,on),qe.bind(xa,on)}}return on}function ur(w,B){w.ambientLightColor.needsUpdate=B,w.lightProbe.needsUpdate=B,w.sunLights.needsUpdate=B,w.sunLightShadows.needsUpdate=B,w.directionalLights.needsUpdate=B,w.directionalLightShadows.needsUpdate=B,w.pointLights.needsUpdate=B,w.pointLightShadows.needsUpdate=B,w.spotLights.needsUpdate=B,w.spotLightShadows.needsUpdate=B,w.rectAreaLights.needsUpdate=B,w.hemisphereLights.needsUpdate=B}function hs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(w,B,Q){let q=Xe.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Xe.get(w.texture).__webglTexture=B,Xe.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Q,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,B){let Q=Xe.get(w);Q.__webglFramebuffer=B,Q.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(w,B=0,Q=0){ae=w,Y=B,k=Q;let q=null,Z=!1,Ce=!1;if(w){let Re=Xe.get(w);if(Re.__useDefaultFramebuffer!==void 0){Ae.bindFramebuffer(N.FRAMEBUFFER,Re.__webglFramebuffer),ne.copy(w.viewport),he.copy(w.scissor),ce=w.scissorTest,Ae.viewport(ne),Ae.scissor(he),Ae.setScissorTest(ce),$=-1;return}else if(Re.__webglFramebuffer===void 0)Ze.setupRenderTarget(w);else if(Re.__hasExternalTextures)Ze.rebindTextures(w,Xe.get(w.texture).__webglTexture,Xe.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let nt=w.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&Xe.has(nt)&&(w.width!==nt.image.width||w.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(w)}}let Ne=w.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ce=!0);let He=Xe.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(He[B])?q=He[B][Q]:q=He[B],Z=!0):w.samples>0&&Ze.useMultisampledRTT(w)===!1?q=Xe.get(w).__webglMultisampledFramebuffer:Array.isArray(He)?q=He[Q]:q=He,ne.copy(w.viewport),he.copy(w.scissor),ce=w.scissorTest}else ne.copy(We).multiplyScalar(Se).floor(),he.copy(fe).multiplyScalar(Se).floor(),ce=Le;if(Q!==0&&(q=O),Ae.bindFramebuffer(N.FRAMEBUFFER,q)&&Ae.drawBuffers(w,q),Ae.viewport(ne),Ae.scissor(he),Ae.setScissorTest(ce),Z){let Re=Xe.get(w.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+B,Re.__webglTexture,Q)}else if(Ce){let Re=B;for(let Ne=0;Ne<w.textures.length;Ne++){let He=Xe.get(w.textures[Ne]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+Ne,He.__webglTexture,Q,Re)}}else if(w!==null&&Q!==0){let Re=Xe.get(w.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Re.__webglTexture,Q)}$=-1};function hr(w){let B=Xe.get(w);return(B.__readFormat!==w.format||B.__readType!==w.type)&&(B.__readFormat=w.format,B.__readType=w.type,B.__formatReadable=rt.textureFormatReadable(w.format),B.__typeReadable=rt.textureTypeReadable(w.type)),B}this.readRenderTargetPixels=function(w,B,Q,q,Z,Ce,De,Re=0){if(!(w&&w.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Xe.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ae.bindFramebuffer(N.FRAMEBUFFER,Ne);try{let He=w.textures[Re],nt=He.format,gt=He.type;w.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+Re);let Ge=hr(He);if(Ge.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=w.width-q&&Q>=0&&Q<=w.height-Z&&N.readPixels(B,Q,q,Z,xe.convert(nt),xe.convert(gt),Ce)}finally{let He=ae!==null?Xe.get(ae).__webglFramebuffer:null;Ae.bindFramebuffer(N.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(w,B,Q,q,Z,Ce,De,Re=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Xe.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(B>=0&&B<=w.width-q&&Q>=0&&Q<=w.height-Z){Ae.bindFramebuffer(N.FRAMEBUFFER,Ne);let He=w.textures[Re],nt=He.format,gt=He.type;w.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+Re);let Ge=hr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,_t),N.bufferData(N.PIXEL_PACK_BUFFER,Ce.byteLength,N.STREAM_READ),N.readPixels(B,Q,q,Z,xe.convert(nt),xe.convert(gt),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let $t=ae!==null?Xe.get(ae).__webglFramebuffer:null;Ae.bindFramebuffer(N.FRAMEBUFFER,$t);let Lt=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await Ym(N,Lt,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,_t),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,Ce),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(_t),N.deleteSync(Lt),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,B=null,Q=0){let q=Math.pow(2,-Q),Z=Math.floor(w.image.width*q),Ce=Math.floor(w.image.height*q),De=B!==null?B.x:0,Re=B!==null?B.y:0;Ze.setTexture2D(w,0),N.copyTexSubImage2D(N.TEXTURE_2D,Q,0,0,De,Re,Z,Ce),Ae.unbindTexture()},this.copyTextureToTexture=function(w,B,Q=null,q=null,Z=0,Ce=0){let De,Re,Ne,He,nt,gt,Ge,_t,$t,Lt=w.isCompressedTexture?w.mipmaps[Ce]:w.image;if(Q!==null)De=Q.max.x-Q.min.x,Re=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,nt=Q.min.y,gt=Q.isBox3?Q.min.z:0;else{let dt=Math.pow(2,-Z);De=Math.floor(Lt.width*dt),Re=Math.floor(Lt.height*dt),w.isDataArrayTexture?Ne=Lt.depth:w.isData3DTexture?Ne=Math.floor(Lt.depth*dt):Ne=1,He=0,nt=0,gt=0}q!==null?(Ge=q.x,_t=q.y,$t=q.z):(Ge=0,_t=0,$t=0);let Dt=xe.convert(B.format),hn=xe.convert(B.type),Be;B.isData3DTexture?(Ze.setTexture3D(B,0),Be=N.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Ze.setTexture2DArray(B,0),Be=N.TEXTURE_2D_ARRAY):(Ze.setTexture2D(B,0),Be=N.TEXTURE_2D),Ae.activeTexture(N.TEXTURE0),Ae.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,B.flipY),Ae.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),Ae.pixelStorei(N.UNPACK_ALIGNMENT,B.unpackAlignment);let rn=Ae.getParameter(N.UNPACK_ROW_LENGTH),vt=Ae.getParameter(N.UNPACK_IMAGE_HEIGHT),qi=Ae.getParameter(N.UNPACK_SKIP_PIXELS),on=Ae.getParameter(N.UNPACK_SKIP_ROWS),fr=Ae.getParameter(N.UNPACK_SKIP_IMAGES);Ae.pixelStorei(N.UNPACK_ROW_LENGTH,Lt.width),Ae.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Lt.height),Ae.pixelStorei(N.UNPACK_SKIP_PIXELS,He),Ae.pixelStorei(N.UNPACK_SKIP_ROWS,nt),Ae.pixelStorei(N.UNPACK_SKIP_IMAGES,gt);let Li=w.isDataArrayTexture||w.isData3DTexture,Yi=B.isDataArrayTexture||B.isData3DTexture;if(w.isDepthTexture){let dt=Xe.get(w),Qt=Xe.get(B),Ln=Xe.get(dt.__renderTarget),Nt=Xe.get(Qt.__renderTarget);Ae.bindFramebuffer(N.READ_FRAMEBUFFER,Ln.__webglFramebuffer),Ae.bindFramebuffer(N.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let an=0;an<Ne;an++)Li&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Xe.get(w).__webglTexture,Z,gt+an),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Xe.get(B).__webglTexture,Ce,$t+an)),N.blitFramebuffer(He,nt,He+De,nt+Re,Ge,_t,Ge+De,_t+Re,N.DEPTH_BUFFER_BIT,N.NEAREST);Ae.bindFramebuffer(N.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Xe.has(w)){let dt=Xe.get(w),Qt=Xe.get(B);Ae.bindFramebuffer(N.READ_FRAMEBUFFER,I),Ae.bindFramebuffer(N.DRAW_FRAMEBUFFER,V);for(let Ln=0;Ln<Ne;Ln++)Li?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,dt.__webglTexture,Z,gt+Ln):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,dt.__webglTexture,Z),Yi?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Qt.__webglTexture,Ce,$t+Ln):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Qt.__webglTexture,Ce),Z!==0?N.blitFramebuffer(He,nt,He+De,nt+Re,Ge,_t,Ge+De,_t+Re,N.COLOR_BUFFER_BIT,N.NEAREST):Yi?N.copyTexSubImage3D(Be,Ce,Ge,_t,$t+Ln,He,nt,De,Re):N.copyTexSubImage2D(Be,Ce,Ge,_t,He,nt,De,Re);Ae.bindFramebuffer(N.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else Yi?w.isDataTexture||w.isData3DTexture?N.texSubImage3D(Be,Ce,Ge,_t,$t,De,Re,Ne,Dt,hn,Lt.data):B.isCompressedArrayTexture?N.compressedTexSubImage3D(Be,Ce,Ge,_t,$t,De,Re,Ne,Dt,Lt.data):N.texSubImage3D(Be,Ce,Ge,_t,$t,De,Re,Ne,Dt,hn,Lt):w.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,Ce,Ge,_t,De,Re,Dt,hn,Lt.data):w.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,Ce,Ge,_t,Lt.width,Lt.height,Dt,Lt.data):N.texSubImage2D(N.TEXTURE_2D,Ce,Ge,_t,De,Re,Dt,hn,Lt);Ae.pixelStorei(N.UNPACK_ROW_LENGTH,rn),Ae.pixelStorei(N.UNPACK_IMAGE_HEIGHT,vt),Ae.pixelStorei(N.UNPACK_SKIP_PIXELS,qi),Ae.pixelStorei(N.UNPACK_SKIP_ROWS,on),Ae.pixelStorei(N.UNPACK_SKIP_IMAGES,fr),Ce===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&N.generateMipmap(Be),Ae.unbindTexture()},this.initRenderTarget=function(w){Xe.get(w).__webglFramebuffer===void 0&&Ze.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Ze.setTextureCube(w,0):w.isData3DTexture?Ze.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Ze.setTexture2DArray(w,0):Ze.setTexture2D(w,0),Ae.unbindTexture()},this.resetState=function(){Y=0,k=0,ae=null,Ae.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return fi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var Dg={type:"change"},pf={type:"start"},Ug={type:"end"},Vc=new tr,Ng=new Qn,Ow=Math.cos(70*Jh.DEG2RAD),gn=new W,Gn=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},df=1e-6,Gc=class extends jo{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Is.ROTATE,MIDDLE:Is.DOLLY,RIGHT:Is.PAN},this.touches={ONE:Ls.ROTATE,TWO:Ls.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new ei,this._lastTargetPosition=new W,this._quat=new ei().setFromUnitVectors(e.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ps,this._sphericalDelta=new Ps,this._scale=1,this._panOffset=new W,this._rotateStart=new lt,this._rotateEnd=new lt,this._rotateDelta=new lt,this._panStart=new lt,this._panEnd=new lt,this._panDelta=new lt,this._dollyStart=new lt,this._dollyEnd=new lt,this._dollyDelta=new lt,this._dollyDirection=new W,this._mouse=new lt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=kw.bind(this),this._onPointerDown=Bw.bind(this),this._onPointerUp=zw.bind(this),this._onContextMenu=Yw.bind(this),this._onMouseWheel=Hw.bind(this),this._onKeyDown=Ww.bind(this),this._onTouchStart=Xw.bind(this),this._onTouchMove=qw.bind(this),this._onMouseDown=Vw.bind(this),this._onMouseMove=Gw.bind(this),this._interceptControlDown=$w.bind(this),this._interceptControlUp=Zw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Dg),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;gn.copy(t).sub(this.target),gn.applyQuaternion(this._quat),this._spherical.setFromVector3(gn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Gn:i>Math.PI&&(i-=Gn),s<-Math.PI?s+=Gn:s>Math.PI&&(s-=Gn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(gn.setFromSpherical(this._spherical),gn.applyQuaternion(this._quatInverse),t.copy(this.target).add(gn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=gn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=gn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Vc.origin.copy(this.object.position),Vc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Vc.direction))<Ow?this.object.lookAt(this.target):(Ng.setFromNormalAndCoplanarPoint(this.object.up,this.target),Vc.intersectPlane(Ng,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>df||8*(1-this._lastQuaternion.dot(this.object.quaternion))>df||this._lastTargetPosition.distanceToSquared(this.target)>df?(this.dispatchEvent(Dg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Gn/60*this.autoRotateSpeed*e:Gn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){gn.setFromMatrixColumn(t,0),gn.multiplyScalar(-e),this._panOffset.add(gn)}_panUp(e,t){this.screenSpacePanning===!0?gn.setFromMatrixColumn(t,1):(gn.setFromMatrixColumn(t,0),gn.crossVectors(this.object.up,gn)),gn.multiplyScalar(e),this._panOffset.add(gn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;gn.copy(s).sub(this.target);let r=gn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Gn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Gn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Gn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Gn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new lt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function Bw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function kw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function zw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ug),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Vw(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Is.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Rt.DOLLY;break;case Is.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}break;case Is.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(pf)}function Gw(n){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Hw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(n.preventDefault(),this.dispatchEvent(pf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ug))}function Ww(n){this.enabled!==!1&&this._handleKeyDown(n)}function Xw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ls.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(n),this.state=Rt.TOUCH_ROTATE;break;case Ls.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(n),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case Ls.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Rt.TOUCH_DOLLY_PAN;break;case Ls.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(pf)}function qw(n){switch(this._trackPointer(n),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Rt.NONE}}function Yw(n){this.enabled!==!1&&n.preventDefault()}function $w(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Zw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Pn={side:0,against:1,opening:2};function mf(n,e){let t=n.length/e;for(let i=0;i<e;i++)for(let s=i*t+1;s<(i+1)*t;s++)n[s]+=n[s-1];return n}var Hc=async n=>new Uint8Array(await vr(n)),Fg=async(n,e)=>mf(new Uint16Array(await vr(n)),e),Wc=async(n,e)=>mf(new Uint32Array(await vr(n)),e),Kw=async n=>mf(new Int16Array(await vr(n)),3),Jw=192e6;function Og(n){let e=new Map,t=0;return i=>{let s=e.get(i);if(s)return e.delete(i),e.set(i,s),s;let r=n(i);return e.set(i,r),r.then(async o=>{t+=o.byteLength;for(let[a,l]of e){if(t<=Jw||a===i)break;e.delete(a),t-=(await l).byteLength}},()=>e.delete(i)),r}}var ha=Og(Hc),Bg=Og(Kw);var fa=[[0,4,7,3],[1,2,6,5],[0,1,5,4],[3,7,6,2],[0,3,2,1],[4,5,6,7]],jw=(n,e,t)=>(n.groups[e][t>>3]>>(t&7)&1)===1,Xc=(n,e)=>n.held.groups.filter((t,i)=>jw(n,i,e)).map(t=>t.name);function kg(n){let e=n.origin,t=e.map((s,r)=>s+n.step[r]*65535);return{centre:e.map((s,r)=>(s+t[r])/2),low:e,high:t,diagonal:Math.hypot(...e.map((s,r)=>t[r]-s))}}async function zg(n,e,t){let i=n.parts[e],[s,r,o,a,l,...c]=await Promise.all([Fg(i.points.block,3),Wc(i.cells.block,i.cells.corners),Wc(i.elements,1),Wc(i.faces.block,1),Hc(i.faces.kind),...i.groups.map(d=>Hc(d.block))]),u=i.points.count,h=new Float32Array(3*u);for(let d=0;d<3;d++){let m=n.origin[d]-t.centre[d];for(let y=0;y<u;y++)h[3*y+d]=m+n.step[d]*s[d*u+y]}let{corners:f}=i.cells;return{held:i,index:e,points:h,cells:r,count:i.cells.count,corners:f,elements:o,faces:a,faceKinds:l,groups:c}}function qc(n,e,t=null){let i=n.held.groups.flatMap((r,o)=>e.has(r.name)?[n.groups[o]]:[]);if(i.length===0)return t;let s=new Uint8Array(n.count);for(let r=0;r<n.count;r++)s[r]=t&&!t[r]||i.some(o=>o[r>>3]>>(r&7)&1)?0:1;return s}var Qw={x:new W(1,0,0),y:new W(0,-1,0),z:new W(0,0,1)},e1=[new W(1,-.42,.3),new W(.42,-1,.3)];function Vg(n,e){let t=new W(1/0,1/0,1/0),i=t.clone().negate(),s=(r,o)=>{let a=new W().fromArray(r.points,3*o);t.min(a),i.max(a)};for(let r of n.filter(o=>o.held.kind==="lining"))for(let o=0;o<r.points.length/3;o++)s(r,o);if(t.x>i.x)for(let r of n.filter(o=>o.corners===8))r.faces.forEach((o,a)=>{if(r.faceKinds[a]===Pn.opening)for(let l of fa[o%6])s(r,r.cells[l*r.count+Math.floor(o/6)])});return t.x>i.x&&(i.set(...e.high).sub(new W(...e.centre)),t.copy(i).negate()),{low:t,high:i}}function Gg(n,e,t,i,s){let r=new On(28,1,e.diagonal/1e3,e.diagonal*12);r.up.set(0,0,1);let o=new Gc(r,n);o.addEventListener("change",s),o.minDistance=e.diagonal/200,o.maxDistance=e.diagonal*6,o.enableZoom=!1,n.addEventListener("focus",()=>o.enableZoom=!0),n.addEventListener("blur",()=>o.enableZoom=!1);let a=()=>{let m=r.fov/2*Math.PI/180;return Math.min(m,Math.atan(Math.tan(m)*r.aspect))},l=m=>{if(m===r.aspect)return;let y=a();r.aspect=m,r.updateProjectionMatrix();let p=Math.sin(y)/Math.sin(a());r.position.sub(o.target).multiplyScalar(p).add(o.target),o.update()},c=new W(...e.high).sub(new W(...e.centre)),u=m=>{let[y,p]=m==="whole"?[c.clone().negate(),c]:[t.low,t.high],g=m==="whole"||m==="oblique"?e1[i]:Qw[m],v=y.distanceTo(p)/2*(m==="whole"?.95:.98);o.target.copy(y).add(p).divideScalar(2),r.position.copy(g).normalize().multiplyScalar(v/Math.sin(a())).add(o.target),m==="z"&&(r.position.y-=1e-4*v),o.update(),s()},h=(m,y,p)=>{let g=r.position.clone().sub(o.target),v=new Ps().setFromCartesianCoords(g.x,g.z,-g.y);v.theta+=m,v.phi+=y,v.radius*=p,v.makeSafe();let{x:T,y:S,z:C}=new W().setFromSpherical(v);r.position.set(T,-C,S).add(o.target),o.update(),s()},f=Math.PI/24,d={ArrowLeft:()=>h(-f,0,1),ArrowRight:()=>h(f,0,1),ArrowUp:()=>h(0,-f,1),ArrowDown:()=>h(0,f,1),"+":()=>h(0,0,1/1.15),"=":()=>h(0,0,1/1.15),"-":()=>h(0,0,1.15)};return n.addEventListener("keydown",m=>{let y=d[m.key];!y||m.ctrlKey||m.metaKey||m.altKey||(y(),m.preventDefault())}),{camera:r,look:u,aim:l}}var Yc=[[252,253,191],[254,207,146],[254,159,109],[247,112,92],[222,73,104],[183,55,121],[140,41,129],[100,26,128],[59,15,112]];function t1(n){let e=Math.abs(2*n-1),t=(n<.5?255:30)*Math.PI/180,i=.97-.57*e,s=.17*Math.min(1,1.25*e)*(1-.25*e);return n1(i,s*Math.cos(t),s*Math.sin(t))}function n1(n,e,t){let i=(n+.3963377774*e+.2158037573*t)**3,s=(n-.1055613458*e-.0638541728*t)**3,r=(n-.0894841775*e-1.291485548*t)**3;return[4.0767416621*i-3.3077115913*s+.2309699292*r,-1.2684380046*i+2.6097574011*s-.3413193965*r,-.0041960863*i-.7034186147*s+1.707614701*r].map(a=>{let l=Math.min(1,Math.max(0,a));return 255*(l<=.0031308?12.92*l:1.055*l**(1/2.4)-.055)})}function i1(n){let e=n*(Yc.length-1),t=Math.min(Math.floor(e),Yc.length-2);return Yc[t].map((i,s)=>i+(e-t)*(Yc[t+1][s]-i))}function Hg({low:n,high:e}){return n<0&&e>0&&Math.min(-n,e)>.04*Math.max(-n,e)?"diverging":e>-n?"rising":"falling"}function $c(n,{low:e,high:t}){if(n==="diverging")return{scale:.5/Math.max(-e,t),shift:.5};let i=1/(t-e||1);return n==="falling"?{scale:-i,shift:t*i}:{scale:i,shift:-e*i}}function da(n){let e=new Uint8Array(1024);for(let t=0;t<256;t++){let i=s1(n,t/255);e.set([...i.map(Math.round),255],4*t)}return e}function s1(n,e){if(typeof n=="string")return n==="diverging"?t1(e):i1(e);let t=Math.min(n.most,Math.floor(e*(n.most+1)));return n.kinds[n.kind(t)].colour}var Pe=Sa({view:"The model in three dimensions",canvas:"The model. Drag to turn, right button or two fingers to shift, arrow keys and + − to turn and come nearer, Enter for the value in the middle.",hint:"Drag to turn, click for the value under the pointer; once the model has been clicked, the wheel zooms.",noGraphics:"This browser shows no WebGL 2 graphics, so the model cannot be turned here; the figures of this page do not need it.",unreadable:"The numbers of the model in this page cannot be read; the figures of this page do not need them.",lost:"The graphics card has let go of the picture; it comes back by itself where the browser allows it.",loading:"The model is being read …",field:"Field",time:"Time",timeLeft:"Time, left",timeRight:"Time, right",stage:"Stage",stageLeft:"Stage, left",stageRight:"Stage, right",play:"Play",stop:"Stop",beside:"Two times side by side",range:"Colours span",ranges:{all:"all times",now:"the time shown",own:"own limits"},colourRock:"Colour the rock too",lowest:"from",highest:"to",deformation:"Deformation",deformedBy:n=>`displacement × ${n}, relative to the mean motion`,deformationNote:"Drawn is the displacement less the mean motion of the whole model at that time, which strains nothing.",cuts:"Cut planes",cutAxis:n=>`Cut across ${n}`,cutAt:n=>`${n} of the cut, m`,turnCut:n=>`Cut away the other side of ${n}`,cutAll:"Cut the lining too",shown:"Shown",rockStyle:"Rock as",rockStyles:{section:"section and outline",translucent:"translucent sides",solid:"solid body"},openings:"Walls of the caverns",edges:"Edges of elements",flow:"Flow of the water",groups:n=>`Groups of ${n}`,groupsNote:"A group that is not ticked hides its elements.",viewButtons:"Look from",lookFrom:{oblique:"Reset",x:"along x",y:"along y",z:"along z"},whole:"Whole model",picture:"Save PNG",pictureName:"model.png",nothing:"no value",noValueHere:"nothing there",element:n=>`element ${n}`,halfLevel:(n,e)=>`${n} ± ${e}`,worstOfFace:"the worst of the element's points",pairs:["bonded","stuck, bond broken","sliding","open"],cracks:["no crack","longitudinal","round the ring","parallel to the wall","where walls meet"],plasticKinds:["elastic","in shear","in tension","in both"],plasticFlags:["yields in shear","yields in tension","yielded in shear before","yielded in tension before"],and:", ",suggested:n=>`× ${n}: well seen`,suggestedHint:"The displacement is drawn as large as is easily seen: the largest is about 3 % of the model.",about:"What this view holds and leaves out",halfLevelNote:"± half a step of the values as this page holds them; result files and tables hold them in full.",relativeDisplacement:"displacement relative to the mean motion",totalDisplacement:"displacement",cutNamed:(n,e)=>`cut at ${n} = ${e} m`,leftOut:n=>`${n}: this page leaves out this time`,notMoved:n=>`${n}: drawn without displacement, which this page leaves out at this time`},{view:"三维模型",canvas:"模型。拖动旋转，右键或双指平移，方向键与 + − 旋转和缩放，回车键显示画面中心处的数值。",hint:"拖动旋转，单击显示指针处的数值；单击模型后可用滚轮缩放。",noGraphics:"此浏览器不支持 WebGL 2 图形，因此这里不能旋转模型；本页其他图不受影响。",unreadable:"本页中的模型数据无法读取；本页其他图不受影响。",lost:"显卡已释放图像；浏览器允许时会自动恢复。",loading:"正在读取模型……",field:"物理量",time:"时刻",timeLeft:"左侧时刻",timeRight:"右侧时刻",stage:"阶段",stageLeft:"左侧阶段",stageRight:"右侧阶段",play:"播放",stop:"停止",beside:"并排显示两个时刻",range:"色标范围",ranges:{all:"全部时刻",now:"当前时刻",own:"自定义"},colourRock:"围岩也着色",lowest:"下限",highest:"上限",deformation:"变形放大",deformedBy:n=>`位移（相对于平均运动）× ${n}`,deformationNote:"所绘为扣除该时刻全模型平均运动后的位移；平均运动不产生应变。",cuts:"剖切面",cutAxis:n=>`垂直于 ${n} 剖切`,cutAt:n=>`剖面的 ${n} 坐标，m`,turnCut:n=>`切去 ${n} 的另一侧`,cutAll:"同时剖切衬砌",shown:"显示",rockStyle:"围岩显示为",rockStyles:{section:"剖面与轮廓",translucent:"半透明边界",solid:"实体"},openings:"洞室壁面",edges:"单元边线",flow:"渗流方向",groups:n=>`${n} 的分组`,groupsNote:"未勾选的分组，其单元不显示。",viewButtons:"视角",lookFrom:{oblique:"复位",x:"沿 x",y:"沿 y",z:"沿 z"},whole:"整个模型",picture:"保存 PNG",pictureName:"模型.png",nothing:"无数值",noValueHere:"此处无数值",element:n=>`单元 ${n}`,halfLevel:(n,e)=>`${n} ± ${e}`,worstOfFace:"取该单元各点中最不利者",pairs:["粘结","粘结破坏，未滑移","滑移","张开"],cracks:["无裂缝","纵向","环向","平行于壁面","墙体交接处"],plasticKinds:["弹性","剪切","受拉","两者"],plasticFlags:["正在剪切屈服","正在受拉屈服","曾剪切屈服","曾受拉屈服"],and:"，",suggested:n=>`× ${n}：清晰`,suggestedHint:"按易于辨认的比例绘制位移：最大位移约为模型尺寸的 3 %。",about:"本视图包含与省略的数据",halfLevelNote:"± 为本页数据量化间隔的一半；完整数值见结果文件和表格。",relativeDisplacement:"相对于平均运动的位移",totalDisplacement:"位移",cutNamed:(n,e)=>`剖面 ${n} = ${e} m`,leftOut:n=>`${n}：本页未含此时刻的数据`,notMoved:n=>`${n}：本页未含此时刻的位移，按未变形绘制`});var r1={most:3,kinds:[[221,225,230],[146,190,222],[240,162,62],[178,34,44]].map((n,e)=>({name:Pe.pairs[e],colour:n})),kind:n=>n,words:n=>Pe.pairs[n]??String(n)},o1={most:15,kinds:[[221,225,230],[229,138,74],[74,144,200],[142,74,158]].map((n,e)=>({name:Pe.plasticKinds[e],colour:n})),kind:n=>(n&5?1:0)+(n&10?2:0),words:n=>{let e=Pe.plasticFlags.filter((t,i)=>n&1<<i);return e.length?e.join(Pe.and):Pe.plasticKinds[0]}},a1={most:4,kinds:[[221,225,230],[31,101,168],[120,178,214],[200,60,50],[150,150,110]].map((n,e)=>({name:Pe.cracks[e],colour:n})),kind:n=>n,words:n=>Pe.cracks[n]??String(n)};function Zc(n){return n==="plastic_state"?o1:n==="crack_direction"?a1:n==="state"?r1:null}var Wg=({most:n})=>({low:-.5,high:n+.5});function Xg(n,e){return .03*e.diagonal/n.displacementLargest}function qg(n,e){let t=Xg(n,e),i=[0,1];if(!Number.isFinite(t))return i;for(let s=1;s<=1e12;s*=10)for(let r of[2,5,10])r*s<=t*20&&i.push(r*s);return i}function Yg(n,e,t){let i=s=>Math.abs(Math.log(s/Xg(e,t)));return n.slice(2).reduce((s,r)=>s===null||i(r)<i(s)?r:s,null)}function $g(n,e){let t=[0,1].map(i=>(e.high.getComponent(i)-e.low.getComponent(i))/(n.high[i]-n.low[i]||1));return t[0]>t[1]*1.01?0:1}function Zg(n,e,t,i){let s=n.times.length-1,r=o=>({on:o===i,at:e.centre[o],keep:o===1?1:-1});return{field:(t.find(o=>o.name==="d_b_max")??t.find(o=>o.name==="d_b")??t[0])?.name??"",times:[0,s],beside:!1,cuts:[r(0),r(1),r(2)],cutAll:!1,scale:0,rock:"section",shown:n.parts.map(o=>o.kind!=="interface"),hidden:n.parts.map(()=>new Set),openings:!0,edges:!0,flow:!0,colourRock:!1,range:"all",own:{low:0,high:1}}}var gf=["x","y","z"],l1=n=>n.clock==="stages"?{one:Pe.stage,left:Pe.stageLeft,right:Pe.stageRight}:{one:Pe.time,left:Pe.timeLeft,right:Pe.timeRight};function Kg(n){let e=Object.keys(Pe.lookFrom).map(t=>Ys(Pe.lookFrom[t],()=>n.look(t)));return Je("div",{class:"view-tools",role:"toolbar","aria-label":Pe.viewButtons},...e,Ys(Pe.whole,()=>n.look("whole")),Ys(Pe.picture,()=>n.picture()))}function Jg(n,e,t,i,s,r){let o=matchMedia("(min-width: 700px)").matches,{changed:a}=r,l=Xa(Pe.field,i.map(O=>[O.name,O.label]),t.field,O=>{t.field=O,a()}),c=Xa(Pe.range,Object.entries(Pe.ranges),t.range,O=>{t.range=O,a()}),u=(O,I)=>qu(O,V=>{t.own={...t.own,[I]:V/r.factor()},t.range=c.input.value="own",a()}),h=u(Pe.lowest,"low"),f=u(Pe.highest,"high"),d=Je("span",{class:"view-unit"}),m=Bi(Pe.colourRock,t.colourRock,O=>{t.colourRock=O,a()}),y=l1(n),p=[0,1].map(O=>Xu(y.one,n.times.length-1,t.times[O],I=>n.times[I].label,I=>{t.times[O]=I,a()})),g=()=>{p[0].row.hidden=!t.beside,p[0].row.firstElementChild.textContent=y.left,p[1].row.firstElementChild.textContent=t.beside?y.right:y.one};g();let v=Bi(Pe.beside,t.beside,O=>{t.beside=O,g(),a()}),T=0,S=Ys(Pe.play,()=>{T?(clearInterval(T),T=0):T=window.setInterval(()=>{t.times[1]=(t.times[1]+1)%n.times.length,p[1].set(t.times[1]),a()},500),S.textContent=T?Pe.stop:Pe.play}),C=n.parts.some(O=>O.kind==="rock")&&n.parts.some(O=>O.kind!=="rock"),A=n.times.length>1,x=Xu(Pe.deformation,s.length-1,s.indexOf(t.scale),O=>`× ${s[O]}`,O=>{t.scale=s[O],a()}),E=Yg(s,n,e),z=E===null?null:Ys(Pe.suggested(String(E)),()=>{t.scale=E,x.set(s.indexOf(E)),a()},Pe.suggestedHint),U=Je("div",{class:"view-row view-limits"},Je("span",{},Pe.lowest),h,Je("span",{},Pe.highest),f,d),D=u1(e,t,a),H=h1(n,t,a);return{element:Je("form",{class:"view-controls"},Dr(Pe.field,!0,l.row,c.row,U,C?m.row:null),Dr(y.one,!0,...A?[p[0].row,p[1].row,Je("div",{class:"view-row"},S),v.row]:[],n.displacementStep>0?x.row:null,n.displacementStep>0&&z?Je("div",{class:"view-row view-indented"},z):null,n.displacementStep>0?Je("p",{class:"note"},Pe.deformationNote):null),Dr(Pe.cuts,o,...D.rows),Dr(Pe.shown,o,...H.rows)),tell(O){c.row.hidden=U.hidden=O.coded,l.input.value=t.field,H.tell(),c.input.value=t.range,v.input.checked=t.beside,m.input.checked=t.colourRock,g(),p.forEach((I,V)=>I.set(t.times[V])),D.tell(),x.set(s.indexOf(t.scale));for(let[I,V]of[[h,O.low],[f,O.high]])document.activeElement!==I&&(I.value=c1(V,O.high-O.low));d.textContent=O.unit}}}var c1=(n,e)=>String(Number(n.toFixed(Math.min(12,Math.max(0,3-Math.floor(Math.log10(e)))))));function u1(n,e,t){let s=[],r=gf.map((a,l)=>{let c=e.cuts[l],u=n.high[l]-n.low[l],h=Bi(a,c.on,g=>{c.on=g,t()});h.input.setAttribute("aria-label",Pe.cutAxis(a));let f=Je("input",{type:"range",min:"0",max:String(240),step:"1","aria-label":Pe.cutAt(a)}),d=qu(Pe.cutAt(a),g=>y(Math.min(n.high[l],Math.max(n.low[l],g)))),m=()=>{f.value=String((c.at-n.low[l])/(u||1)*240),f.setAttribute("aria-valuetext",`${c.at.toFixed(1)} m`),d.value=String(Number(c.at.toFixed(2))),h.input.checked=c.on},y=g=>{c.at=g,c.on=!0,m(),t()};f.addEventListener("input",()=>y(n.low[l]+u*Number(f.value)/240)),m(),s.push(m);let p=Ys("⇄",()=>{c.keep=c.keep>0?-1:1,t()},Pe.turnCut(a));return Je("div",{class:"view-row view-cut"},h.row,f,d,Je("span",{},"m"),p)}),o=Bi(Pe.cutAll,e.cutAll,a=>{e.cutAll=a,t()});return s.push(()=>o.input.checked=e.cutAll),{rows:[...r,o.row],tell:()=>s.forEach(a=>a())}}function h1(n,e,t){let i=[],s=n.parts.map((u,h)=>{let f=Bi(u.name,e.shown[h],m=>{e.shown[h]=m,t()});if(i.push(()=>f.input.checked=e.shown[h]),u.groups.length<2)return f.row;let d=u.groups.map(({name:m})=>Bi(m,!0,y=>{y?e.hidden[h].delete(m):e.hidden[h].add(m),t()}));return Je("div",{class:"view-part"},f.row,Dr(Pe.groups(u.name),!1,Je("p",{class:"note"},Pe.groupsNote),...d.map(m=>m.row)))}),r=Xa(Pe.rockStyle,Object.entries(Pe.rockStyles),e.rock,u=>{e.rock=u,t()}),o=Bi(Pe.openings,e.openings,u=>{e.openings=u,t()}),a=Bi(Pe.edges,e.edges,u=>{e.edges=u,t()}),l=Bi(Pe.flow,e.flow,u=>{e.flow=u,t()}),c=n.parts.some(u=>u.kind==="rock");return i.push(()=>r.input.value=e.rock,()=>l.input.checked=e.flow),{rows:[...s,...c?[r.row]:[],o.row,a.row,...n.flows.length?[l.row]:[]],tell:()=>i.forEach(u=>u())}}function pa(n,e){let t=[],i=[],s=[],r=[],o=[],a=[],l=new Set,c=n.points.length/3,u=(h,f)=>{let[d,m]=t[h]<t[f]?[t[h],t[f]]:[t[f],t[h]],y=d*c+m;!e&&l.has(y)||(e||l.add(y),a.push(h,f))};return{vertex(h,f,d,m){return t.push(h),i.push(f),s.push(d),r.push(m),t.length-1},polygon(h){for(let f=2;f<h.length;f++)o.push(h[0],h[f-1],h[f]);h.forEach((f,d)=>u(f,h[(d+1)%h.length]))},sheet:()=>({part:n,a:Uint32Array.from(t),b:Uint32Array.from(i),s:Float32Array.from(s),cell:Uint32Array.from(r),triangles:Uint32Array.from(o),lines:Uint32Array.from(a),flat:e})}}function _f(n,e){let{a:t,b:i,s}=n,r=new Float32Array(3*t.length);for(let o=0;o<t.length;o++)for(let a=0;a<3;a++){let l=e[3*t[o]+a];r[3*o+a]=l+s[o]*(e[3*i[o]+a]-l)}return r}var f1=[[0,1],[1,2],[2,3],[3,0],[4,5],[5,6],[6,7],[7,4],[0,4],[1,5],[2,6],[3,7]];function d1(n,e){let t=new Float32Array(n.count).fill(1/0),i=new Float32Array(n.count).fill(-1/0);for(let s=0;s<n.corners;s++)for(let r=0;r<n.count;r++){let o=n.points[3*n.cells[s*n.count+r]+e];o<t[r]&&(t[r]=o),o>i[r]&&(i[r]=o)}return{low:t,high:i}}function jg(n){let e=[];return(t,i,s,r)=>{let o=pa(n,!0);if(n.corners===8){let{low:a,high:l}=e[t]??=d1(n,t);for(let c=0;c<n.count;c++)(s>0?a[c]<=i&&l[c]>i:a[c]<i&&l[c]>=i)&&(!r||r[c])&&p1(n,c,t,i,s,o)}return o.sheet()}}function p1(n,e,t,i,s,r){let[o,a]=[(t+1)%3,(t+2)%3],{points:l}=n,c=[];for(let[f,d]of f1){let m=n.cells[f*n.count+e],y=n.cells[d*n.count+e],p=(l[3*m+t]-i)*s,g=(l[3*y+t]-i)*s;if(p>0==g>0)continue;let v=p/(p-g),T=l[3*m+o]+v*(l[3*y+o]-l[3*m+o]),S=l[3*m+a]+v*(l[3*y+a]-l[3*m+a]);c.some(C=>Math.abs(C.x-T)+Math.abs(C.y-S)<1e-5)||c.push({p:m,q:y,s:v,x:T,y:S,angle:0})}if(c.length<3)return;let u=c.reduce((f,d)=>f+d.x,0)/c.length,h=c.reduce((f,d)=>f+d.y,0)/c.length;for(let f of c)f.angle=Math.atan2(f.y-h,f.x-u);c.sort((f,d)=>f.angle-d.angle),r.polygon(c.map(f=>r.vertex(f.p,f.q,f.s,e)))}function Qg(n,e,t){return(n.corners===4?[0,1,2,3]:fa[t]).map(s=>n.cells[s*n.count+e])}function m1(n,e){if(n.corners===4)return[];let t=new Set(n.faces),i=new Map,s=n.points.length/3;for(let r=0;r<n.count;r++)for(let o=0;o<6;o++){if(t.has(r*6+o))continue;let a=fa[o].map(h=>n.cells[h*n.count+r]),l=a.indexOf(Math.min(...a)),c=a[l]*s+a[(l+2)%4],u=i.get(c);u===void 0?i.set(c,r*6+o):e[r]===e[Math.floor(u/6)]?i.delete(c):i.set(c,e[r]?r*6+o:u)}return[...i.values()].filter(r=>e[Math.floor(r/6)])}function e0(n,e,t){let i=pa(n,!1),s=r=>{let o=Math.floor(r/6),a=Qg(n,o,r%6);i.polygon(a.map(l=>i.vertex(l,l,0,o)))};return n.faces.forEach((r,o)=>{t.includes(n.faceKinds[o])&&(!e||e[Math.floor(r/6)])&&s(r)}),e&&t.includes(Pn.against)&&m1(n,e).forEach(s),i.sheet()}function t0(n,e){let t=pa(n,!1),i=n.points.length/3,s=new Map;n.faces.forEach((r,o)=>{let a=Math.floor(r/6);if(n.faceKinds[o]!==Pn.side||e&&!e[a])return;let l=Qg(n,a,r%6),c=g1(n,l);l.forEach((u,h)=>{let f=l[(h+1)%4],d=Math.min(u,f)*i+Math.max(u,f),m=s.get(d);m?m.sharp=c.reduce((y,p,g)=>y+p*m.normal[g],0)<Math.cos(Math.PI/6):s.set(d,{cell:a,normal:c,sharp:!0,ends:[u,f]})})});for(let{cell:r,sharp:o,ends:a}of s.values())o&&t.polygon(a.map(l=>t.vertex(l,l,0,r)));return t.sheet()}function g1(n,e){let t=(a,l)=>n.points[3*a+l],i=[0,1,2].map(a=>t(e[2],a)-t(e[0],a)),s=[0,1,2].map(a=>t(e[3],a)-t(e[1],a)),r=[i[1]*s[2]-i[2]*s[1],i[2]*s[0]-i[0]*s[2],i[0]*s[1]-i[1]*s[0]],o=Math.hypot(...r)||1;return r.map(a=>a/o)}var ma=(n,e,t)=>n.cuts[t].at-e.centre[t];function n0(n,e){let t=n.map(jg),i=new Map,s=(r,o,a)=>{let l=[],c=(h,f,d,m,y)=>{let p=a.get(h)??i.get(h)??f();a.set(h,p),p.lines.length&&l.push({key:`${h} ${d} ${m} ${y}`,sheet:p,cut:d,opacity:m,lines:y})},u=h=>r.edges?h:0;return n.forEach((h,f)=>{let d=r.hidden[f],m=qc(h,d,o[f].cells),y=`${f} ${[...d].join("|")} ${o[f].key}`,p=h.held.kind==="rock",g=p||r.cutAll;p&&c(`${f} ${o[f].key} outline`,()=>t0(h,o[f].cells),!1,0,.55);let v=(T,S,C)=>c(`${y} faces ${T}`,()=>e0(h,m,T),g,S,C);if(!r.shown[f]){r.openings&&v([Pn.opening],1,u(.2));return}p?(r.rock==="solid"?v([Pn.side,Pn.against,Pn.opening],1,u(.16)):r.openings&&v([Pn.opening,Pn.against],1,u(.2)),r.rock==="translucent"&&v([Pn.side],.25,u(.12))):v([Pn.side,Pn.against,Pn.opening],1,u(.4)),g&&r.cuts.forEach(({on:T,keep:S},C)=>{if(!T)return;let A=ma(r,e,C);c(`${y} cut ${C} ${A} ${S}`,()=>t[f](C,A,S,m),g,1,u(p?.16:.4))})}),l};return(r,o)=>{let a=new Map,l=o.map(c=>s(r,c,a));return i=a,l}}function i0(n,e,t,i){let s=n.flowAt[i]??null;if(!t.flow||s===null)return[];let{beside:r,lines:o}=n.flows[s],a=t.cuts.flatMap(({on:u,keep:h},f)=>u?[{axis:f,keep:h,at:ma(t,e,f)}]:[]),l=u=>{let h=a.map(f=>(u.getComponent(f.axis)-f.at)*f.keep);return h.every(f=>f>=0)&&(!a.length||h.some(f=>f<=r))},c=[];for(let u of o){let h=[],f=null;for(let d=0;d<u.length;d+=3){let m=new W(...[0,1,2].map(y=>u[d+y]-e.centre[y]));f&&l(f.clone().add(m).multiplyScalar(.5))?(h.length||c.push(h=[f]),h.push(m)):h=[],f=m}}return c}var _1={m:[[1,1,"m"],[.001,1e3,"mm"],[1e-6,1e6,"µm"],[1e-9,1e9,"nm"]],"m/s":[[.1,1,"m/s"],[1e-4,1e3,"mm/s"],[1e-7,1e6,"µm/s"]],Pa:[[1e9,1e-9,"GPa"],[1e5,1e-6,"MPa"],[100,.001,"kPa"],[.1,1,"Pa"]]};function s0(n,e){let t=_1[n]?.find(([s])=>e>=s);if(t&&e*t[1]<1e5)return{factor:t[1],unit:t[2]};if(!(e>0)||!Number.isFinite(e)||e>=.01&&e<1e5)return{factor:1,unit:n};let i=3*Math.floor(Math.log10(e)/3+1e-9);return{factor:10**-i,unit:`×10${r0(i)} ${n}`.trim()}}function Kc(n,e){if(n===0)return"0";let t=Math.abs(n);if(t<1e-4||t>=1e6){let[s,r]=n.toExponential(e-1).split("e");return`${cs(s)}×10${r0(Number(r))}`}let i=Math.max(0,e-1-Math.floor(Math.log10(t)));return cs(n.toFixed(Math.min(i,8)))}function xf(n,e){let t=n.toFixed(e);return Number(t)===0?t.replace("-",""):t}var cs=n=>n.replace("-","−"),r0=n=>[...String(n)].map(e=>e==="-"?"⁻":"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(e)]).join(""),yf=(n,e)=>e?`${n} ${e}`:n;function o0(n,e,t){let i=e-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],decimals:2};let s=i/Math.max(1,t),r=10**Math.floor(Math.log10(s)),o=[1,2,5,10].map(l=>l*r).find(l=>l>=s*.999)??10*r,a=[];for(let l=Math.ceil(n/o-1e-6);l*o<=e+o*1e-6;l++)a.push(l*o+0);return{values:a,decimals:Math.max(0,-Math.floor(Math.log10(o)+1e-9))}}var x1="#0b4f9e",y1="#b0561b",lo='12px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';function jc(n,e){n.font=lo,n.textBaseline="middle",n.lineJoin="round",e.panels.forEach((i,s)=>{s>0&&(n.strokeStyle=e.muted,n.globalAlpha=.5,n.strokeRect(i.left-.5,i.top-.5,i.width+2,i.height+2),n.globalAlpha=1),A1(n,e,i);let r=i.width-24-(i.left+i.width===e.width&&e.bar?70:0),o=i.top+16,a=i.lines.flatMap(c=>vf(n,c,r)),l=Math.max(...a.map((c,u)=>v1(n,c,u===0)));ga(n,e,i.left+6,i.top+5,l+14,17*a.length+6),a.forEach((c,u)=>{lr(n,c,i.left+12,o,u===0?e.ink:e.muted,u===0),o+=17})}),e.bar&&S1(n,e,e.bar);let t=e.panels[0];w1(n,e,t.left+38,t.top+t.height-38),e.waves.forEach((i,s)=>E1(n,e,i,t.left+112+74*s,t.top+t.height-44))}function v1(n,e,t){return n.font=t?`600 ${lo}`:lo,n.measureText(e).width}function ga(n,e,t,i,s,r){n.globalAlpha=.82,n.fillStyle=e.paper,n.beginPath(),n.roundRect(t,i,s,r,4),n.fill(),n.globalAlpha=1}function lr(n,e,t,i,s,r=!1){n.font=r?`600 ${lo}`:lo,n.fillStyle=s,n.fillText(e,t,i)}function vf(n,e,t){let i=[],s="";for(let r of e.match(/[\u3000-\uffef]|[^\s\u3000-\uffef]+\s*|\s+/gu)??[])s&&n.measureText(s+r).width>t&&(i.push(s.trimEnd()),s=""),s+=r;return s?[...i,s.trimEnd()]:i}function b1(n,e,t){let i=e.panels[e.panels.length-1],s=20;n.font=lo;let r=Math.max(...t.map(({name:l})=>n.measureText(l).width)),o=e.width-r-40,a=i.top+(i.height-s*t.length)/2;ga(n,e,o-8,a-6,r+40,s*t.length+12),t.forEach(({name:l,colour:c},u)=>{let h=a+s*(u+.5);n.fillStyle=typeof c=="string"?c:`rgb(${c.join()})`,n.fillRect(o,h-6,14,12),n.strokeStyle=e.muted,n.lineWidth=1,n.strokeRect(o+.5,h-5.5,13,11),lr(n,l,o+20,h,e.ink)})}function S1(n,e,t){let{range:i,scheme:s,shown:r,beyond:o}=t;if(typeof s!="string")return b1(n,e,[...s.kinds,...t.nothing?[{name:Pe.nothing,colour:e.nothing}]:[]]);let a=e.panels[e.panels.length-1],l=Math.min(260,a.height*.55),c=a.top+(a.height-l)/2,u=e.width-66,h=14,f=da(s),{scale:d,shift:m}=$c(s,i),y=S=>{let C=d*(i.low+S*(i.high-i.low))+m,A=4*Math.round(255*Math.min(1,Math.max(0,C)));return`rgb(${f[A]},${f[A+1]},${f[A+2]})`};ga(n,e,u-12,c-30,74,l+46);for(let S=0;S<l;S++)n.fillStyle=y(1-(S+.5)/l),n.fillRect(u,c+S,h,1.5);let p=(S,C,A)=>{n.fillStyle=A,n.beginPath(),n.moveTo(u,S),n.lineTo(u+h,S),n.lineTo(u+h/2,C),n.fill()};o.above&&p(c,c-10,y(1)),o.below&&p(c+l,c+l+10,y(0)),n.strokeStyle=e.muted,n.lineWidth=1,n.strokeRect(u+.5,c+.5,h-1,l-1);let[g,v]=[i.low*r.factor,i.high*r.factor],T=o0(g,v,l/45);for(let S of T.values){let C=c+l*(1-(v>g?(S-g)/(v-g):.5));n.strokeStyle=e.muted,n.lineWidth=1,n.beginPath(),n.moveTo(u+h,C),n.lineTo(u+h+4,C),n.stroke(),lr(n,M1(S,T.decimals),u+h+7,C,e.ink)}if(r.unit&&(n.textAlign="center",lr(n,r.unit,u+h/2,c-(o.above?20:12),e.ink),n.textAlign="start"),t.nothing){let S=c+l+30;n.strokeStyle=e.muted,n.lineWidth=1;let C=n.measureText(Pe.nothing).width;ga(n,e,u-C-14,S-10,C+h+20,20),n.fillStyle=e.nothing,n.fillRect(u,S-6,h,12),n.strokeRect(u+.5,S-5.5,h-1,11),lr(n,Pe.nothing,u-C-8,S,e.ink)}}function M1(n,e){let t=Math.abs(n);return cs(t&&(e>5||t>=1e6)?n.toExponential(1):n.toFixed(e))}function w1(n,e,t,i){let s=e.camera.quaternion.clone().invert(),r=[{name:"x",way:new W(1,0,0),colour:"#c4422f"},{name:"y",way:new W(0,1,0),colour:"#2f8f4e"},{name:"z",way:new W(0,0,1),colour:"#3a72c9"}];for(let o of r)o.way.applyQuaternion(s);r.sort((o,a)=>o.way.z-a.way.z),n.textAlign="center";for(let{name:o,way:a,colour:l}of r)n.strokeStyle=l,n.lineWidth=2,n.beginPath(),n.moveTo(t,i),n.lineTo(t+22*a.x,i-22*a.y),n.stroke(),lr(n,o,t+30*a.x,i-30*a.y,l,!0);n.textAlign="start"}function E1(n,e,t,i,s){let r=e.camera.quaternion.clone().invert(),o=(h,f)=>{let d=new W(...h).applyQuaternion(r).multiplyScalar(f);return[d.x,-d.y]};ga(n,e,i-35,s-34,70,76),n.strokeStyle=n.fillStyle=e.ink;let[a,l]=o(t.polarisation,20);n.lineWidth=1,Jc(n,i-a,s-l,i+a,s+l,4),Jc(n,i+a,s+l,i-a,s-l,4),n.strokeStyle=n.fillStyle=y1;let[c,u]=o(t.way,24);n.lineWidth=2.5,Jc(n,i-c,s-u,i+c,s+u,9),n.textAlign="center",lr(n,t.label,i,s+35,e.ink),n.textAlign="start"}function A1(n,e,t){let i=r=>{let{x:o,y:a,z:l}=r.clone().project(e.camera);return{x:t.left+(o+1)/2*t.width,y:t.top+(1-a)/2*t.height,before:l<1}},s=t.flow.map(r=>r.map(i)).filter(r=>r.every(o=>o.before));n.save(),n.beginPath(),n.rect(t.left,t.top,t.width,t.height),n.clip();for(let[r,o,a]of[["#ffffff",2.6,9],[x1,1.1,8]]){n.strokeStyle=n.fillStyle=r,n.lineWidth=o;for(let l of s){n.beginPath(),l.forEach((c,u)=>u?n.lineTo(c.x,c.y):n.moveTo(c.x,c.y)),n.stroke();for(let{x:c,y:u,alongX:h,alongY:f}of R1(l))Jc(n,c-2*h*a,u-2*f*a,c,u,a)}}n.restore()}var T1=110,C1=20;function R1(n){let e=n.slice(1).map((o,a)=>Math.hypot(o.x-n[a].x,o.y-n[a].y)),t=e.reduce((o,a)=>o+a,0),i=[];if(t<C1)return i;let s=t/Math.max(1,Math.round(t/T1)),r=s/2;return e.forEach((o,a)=>{let[l,c]=[(n[a+1].x-n[a].x)/o,(n[a+1].y-n[a].y)/o];for(;r<=o;r+=s)i.push({x:n[a].x+r*l,y:n[a].y+r*c,alongX:l,alongY:c});r-=o}),i}function Jc(n,e,t,i,s,r){let[o,a]=[i-e,s-t],l=Math.hypot(o,a);if(l<1)return;let[c,u]=[o/l,a/l],h=Math.min(r,l/2);n.beginPath(),n.moveTo(e,t),n.lineTo(i-h*c,s-h*u),n.stroke(),n.beginPath(),n.moveTo(i,s),n.lineTo(i-h*c-.45*h*u,s-h*u+.45*h*c),n.lineTo(i-h*c+.45*h*u,s-h*u-.45*h*c),n.fill()}var a0=`
attribute vec3 moved;
attribute vec2 level;
uniform float deform;
varying vec3 vPlace;
varying vec3 vView;
varying vec2 vLevel;
void main() {
  vPlace = position;
  vLevel = level;
  vec4 seen = modelViewMatrix * vec4(position + deform * moved, 1.0);
  vView = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,l0=`
uniform vec3 cutAt;
uniform vec3 cutKeep;
uniform float cutGap;
varying vec3 vPlace;
void cut() {
  if (any(lessThan(cutKeep * (vPlace - cutAt), vec3(-cutGap)))) discard;
}`,P1=`${l0}
uniform sampler2D map;
uniform float placeScale;
uniform float placeShift;
uniform vec3 nothing;
uniform vec3 plainColour;
uniform float plain;
uniform float lit;
uniform float opacity;
varying vec3 vView;
varying vec2 vLevel;
void main() {
  cut();
  float place = clamp(placeScale * vLevel.x + placeShift, 0.0, 1.0);
  vec3 colour = vLevel.y > 0.999 ? texture2D(map, vec2((255.0 * place + 0.5) / 256.0, 0.5)).rgb : nothing;
  colour = mix(colour, plainColour, plain);
  vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
  float light = mix(1.0, 0.84 + 0.16 * abs(normal.z), lit);
  gl_FragColor = vec4(colour * light, opacity);
}`,I1=`${l0}
uniform vec3 ink;
uniform float opacity;
void main() {
  cut();
  gl_FragColor = vec4(ink, opacity);
}`;function c0(n){let e=new jr(da("rising"),256,1);e.magFilter=e.minFilter=En;let t={map:{value:e},placeScale:{value:1},placeShift:{value:0},deform:{value:0},nothing:{value:new ht},ink:{value:new ht},plainColour:{value:new ht},cutGap:{value:1e-5*n}},i={cutAt:{value:new W},cutKeep:{value:new W}},s={cutAt:{value:new W},cutKeep:{value:new W}},r="rising";return{shared:t,planes:i,colours(o,a){o!==r&&(r=o,e.image.data.set(da(r))),e.needsUpdate=!0;let{scale:l,shift:c}=$c(r,a);t.placeScale.value=l,t.placeShift.value=c},fill:(o,a,l,c)=>new ii({uniforms:{...t,...o?i:s,lit:{value:a?0:1},plain:{value:0},opacity:{value:l}},vertexShader:a0,fragmentShader:P1,side:pi,transparent:l<1,depthWrite:l===1,polygonOffset:!0,polygonOffsetFactor:c?2:1,polygonOffsetUnits:c?2:1}),lines:(o,a)=>new ii({uniforms:{...t,...o?i:s,opacity:{value:a}},vertexShader:a0,fragmentShader:I1,transparent:!0,depthWrite:!1})}}function u0(n,e){let{sheet:t,cut:i,opacity:s}=n,r=_f(t,t.part.points),o=new Float32Array(r.length),a=new Float32Array(2*r.length/3),l={position:new Bn(r,3),moved:new Bn(o,3),level:new Bn(a,2)},c=f=>{let d=new Ei;for(let[m,y]of Object.entries(l))d.setAttribute(m,y);return d.setIndex(new Bn(f,1)),d},u=new di(c(t.triangles),e.fill(i,t.flat,s,t.part.held.kind==="rock")),h=new Xo(c(t.lines),e.lines(i,n.lines));return u.frustumCulled=h.frustumCulled=!1,u.visible=s>0,u.renderOrder=s<1?2:0,h.renderOrder=1,{layer:n,place:r,moved:o,level:a,fill:u,lines:h}}function h0(n){for(let e of[n.fill,n.lines])e.geometry.dispose(),e.material.dispose()}function f0({layer:{sheet:n},level:e,fill:t},i){for(let s=0;s<n.cell.length;s++){let r=NaN;i?.at==="cells"?r=i.array[n.cell[s]]:i&&(r=i.array[n.a[s]]+n.s[s]*(i.array[n.b[s]]-i.array[n.a[s]]));let o=!Number.isNaN(r);e[2*s]=o?r:0,e[2*s+1]=o?1:0}t.geometry.attributes.level.needsUpdate=!0}function d0({fill:n},e){n.material.uniforms.plain.value=e?1:0}function p0({layer:{sheet:n},moved:e,fill:t},i){i?e.set(_f(n,i)):e.fill(0),t.geometry.attributes.moved.needsUpdate=!0}var co=["|u - mean|","|u|"],bf=n=>co.includes(n);function m0(n){let e=new Map,t={lining:0,interface:1,rock:2};for(let i of[...n.parts].sort((s,r)=>t[s.kind]-t[r.kind]))for(let{name:s,label:r,unit:o}of i.fields)e.has(s)||e.set(s,{name:s,label:r,unit:o});return n.displacementStep>0&&(e.set(co[0],{name:co[0],label:Pe.relativeDisplacement,unit:"m"}),e.set(co[1],{name:co[1],label:Pe.totalDisplacement,unit:"m"})),[...e.values()]}var Sf=(n,e)=>n.held.fields.find(t=>t.name===e),Qc=(n,e)=>bf(e)?n.held.displacement.some(t=>t!==null):Sf(n,e)!==void 0;async function Mf(n,e,t){let i=e.held.displacement[t]??null;if(i===null||!n.displacementStep)return null;let s=await Bg(i),r=s.length/3,o=new Float32Array(3*r);for(let a=0;a<3;a++)for(let l=0;l<r;l++)o[3*l+a]=n.displacementStep*s[a*r+l];return o}async function wf(n,e,t,i){if(bf(t)){let c=await Mf(n,e,i);if(!c)return null;let[u,h,f]=t===co[1]?n.mean[i]:[0,0,0],d=new Float32Array(c.length/3);for(let m=0;m<d.length;m++)d[m]=Math.hypot(c[3*m]+u,c[3*m+1]+h,c[3*m+2]+f);return{at:"points",array:d,half:Math.sqrt(3)/2*n.displacementStep}}let s=Sf(e,t),r=s?.blocks[i]??null;if(!s||r===null)return null;let o=(s.high-s.low)/254;if(Zc(t)){let c=Float32Array.from({length:256},(h,f)=>f===255?NaN:Math.round(s.low+f*o)),u=Float32Array.from(await ha(r),h=>c[h]);return{at:"cells",array:s.at==="cells"?u:L1(e,u),half:0}}let a=Float32Array.from({length:256},(c,u)=>u===255?NaN:s.low+u*o),l=Float32Array.from(await ha(r),c=>a[c]);return{at:s.at,array:l,half:o/2}}function L1(n,e){return Float32Array.from({length:n.count},(t,i)=>{let s=NaN;for(let r=0;r<n.corners;r++){let o=e[n.cells[r*n.count+i]];s>=o||(s=Number.isNaN(o)?s:o)}return s})}function Ef(n,e,t){let i=1/0,s=-1/0,r=o=>{o<i&&(i=o),o>s&&(s=o)};for(let o=0;o<n.count;o++)if(!(t&&!t[o]))if(e.at==="cells")r(e.array[o]);else for(let a=0;a<n.corners;a++)r(e.array[n.cells[a*n.count+o]]);return i<=s?{low:i,high:s}:null}async function g0(n,e,t){let i=[];for(let s of e){if(!bf(t)){i.push(Sf(s,t)??null);continue}for(let r=0;r<n.times.length;r++){let o=await wf(n,s,t,r);i.push(o&&Ef(s,o,null))}}return Af(i)}function Af(n){let e=n.filter(t=>t!==null);return e.length===0?null:{low:Math.min(...e.map(t=>t.low)),high:Math.max(...e.map(t=>t.high))}}var Tf=()=>({scene:new Go,drawn:[],time:0,values:[],moved:[]});async function _0(n,e,t,i,s,r,o){let[a,l]=await Promise.all([Promise.all(e.map((c,u)=>t[u]?wf(n,c,s,r):null)),Promise.all(e.map((c,u)=>i[u]&&o?Mf(n,c,r):null))]);return{time:r,values:a,moved:l}}function x0(n,e,t,i,s){let r=new Map(n.drawn.map(o=>[o.layer.key,o]));n.drawn=e.map(o=>{let a=r.get(o.key);if(a?.layer.sheet===o.sheet)return r.delete(o.key),a;let l=u0(o,s);return n.scene.add(l.fill,l.lines),l});for(let o of r.values())n.scene.remove(o.fill,o.lines),h0(o);Object.assign(n,t);for(let o of n.drawn){let a=o.layer.sheet.part.index;f0(o,t.values[a]),d0(o,!i.includes(o.layer.sheet.part)),p0(o,t.moved[a])}}function Cf(n,e,t,i,s){let r=new W(i,s,-1).unproject(e),a=new W(i,s,1).unproject(e).clone().sub(r).normalize(),l=t.shared.deform.value,c=1/0,u=null;for(let h of n.drawn){if(h.layer.opacity<1)continue;let{triangles:f}=h.layer.sheet,{place:d,moved:m}=h,y=D1(h.layer.cut,t);for(let p=0;p<f.length;p+=3){let[g,v,T]=[3*f[p],3*f[p+1],3*f[p+2]],S=d[g]+l*m[g],C=d[g+1]+l*m[g+1],A=d[g+2]+l*m[g+2],x=d[v]+l*m[v]-S,E=d[v+1]+l*m[v+1]-C,z=d[v+2]+l*m[v+2]-A,U=d[T]+l*m[T]-S,D=d[T+1]+l*m[T+1]-C,H=d[T+2]+l*m[T+2]-A,O=a.y*H-a.z*D,I=a.z*U-a.x*H,V=a.x*D-a.y*U,Y=x*O+E*I+z*V;if(Y===0)continue;let k=r.x-S,ae=r.y-C,$=r.z-A,J=(k*O+ae*I+$*V)/Y;if(J<0||J>1)continue;let ne=ae*z-$*E,he=$*x-k*z,ce=k*E-ae*x,j=(a.x*ne+a.y*he+a.z*ce)/Y;if(j<0||J+j>1)continue;let pe=(U*ne+D*he+H*ce)/Y;pe<0||pe>=c||y(_e=>d[g+_e]+J*(d[v+_e]-d[g+_e])+j*(d[T+_e]-d[g+_e]))||(c=pe,u={drawn:h,at:p,u:J,v:j})}}return u&&N1(n,u)}function D1(n,e){if(!n)return()=>!1;let t=e.planes.cutKeep.value.toArray(),i=e.planes.cutAt.value.toArray(),s=e.shared.cutGap.value;return r=>t.some((o,a)=>o!==0&&o*(r(a)-i[a])<-s)}function N1(n,{drawn:e,at:t,u:i,v:s}){let{sheet:r}=e.layer,[o,a,l]=r.triangles.subarray(t,t+3),c=d=>d(o)+i*(d(a)-d(o))+s*(d(l)-d(o)),u=[0,1,2].map(d=>c(m=>e.place[3*m+d])),f=[o,a,l].every(d=>e.level[2*d+1]===1)?c(d=>e.level[2*d]):NaN;return{part:r.part,cell:r.cell[o],place:u,value:f,half:n.values[r.part.index]?.half??0}}function y0(n,e,t,i){let s=t.shared.deform.value;for(let r of n.drawn){let{part:o,cell:a,triangles:l}=r.layer.sheet;if(!(r.layer.opacity<1))for(let c=0;c<l.length;c+=3){if(o.elements[a[l[c]]]!==i)continue;let u=new W;for(let m=c;m<c+3;m++){let y=l[m];u.add(new W().fromArray(r.place,3*y).addScaledVector(new W().fromArray(r.moved,3*y),s))}let{x:h,y:f}=u.divideScalar(3).project(e);if(Math.abs(h)>1||Math.abs(f)>1)continue;let d=Cf(n,e,t,h,f);if(d&&d.part===o&&o.elements[d.cell]===i)return[h,f]}}return null}function v0(n,e,t){let i=n.width/e.width,s=document.createElement("canvas"),r=s.getContext("2d"),o='12px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';r.font=o;let a=t.flatMap(l=>vf(r,l,e.width-24));return s.width=n.width,s.height=n.height+Math.round((a.length*17+16)*i),r.fillStyle=e.paper,r.fillRect(0,0,s.width,s.height),r.drawImage(n,0,0),r.scale(i,i),jc(r,e),r.font=o,r.fillStyle=e.ink,a.forEach((l,c)=>r.fillText(l,12,e.height+14+17*c)),new Promise(l=>s.toBlob(l,"image/png"))}function b0(n){let e=document.createElement("a");e.href=URL.createObjectURL(n),e.download=Pe.pictureName,e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function Rf(n,e){let t=n.filter((s,r)=>(e.shown[r]||e.openings)&&Qc(s,e.field)),i=t.filter(s=>s.held.kind!=="rock");return i.length&&!e.colourRock?i:t}function Pf(n,e,t){return Af(n.flatMap(i=>e.map(s=>{let r=i.values[s.index];return r?Ef(s,r,qc(s,t.hidden[s.index])):null})))}function S0(n,e){let t=new Map;return async(i,s)=>{if(i.range==="own")return i.own;let r=Rf(e,i);if(i.range==="now")return Pf(s,r,i);let o=`${i.field} ${r.map(a=>a.index)}`;return t.has(o)||t.set(o,g0(n,r,i.field)),t.get(o)}}var If=255,M0={key:"",cells:null};function w0(n){let e=new Map,t=n.held.fields.find(i=>i.at==="cells")??n.held.fields[0];return async i=>{let s=t?.blocks.slice(0,i+1).filter(r=>r!==null).pop()??null;return!t||s===null?M0:(e.has(s)||e.set(s,ha(s).then(r=>U1(n,t.at,r,String(s)))),e.get(s))}}function U1(n,e,t,i){if(!t.includes(If))return M0;let s=new Uint8Array(n.count);for(let r=0;r<n.count;r++){let o=1;if(e==="cells")o=t[r]===If?0:1;else for(let a=0;a<n.corners;a++)t[n.cells[a*n.count+r]]===If&&(o=0);s[r]=o}return{key:i,cells:s}}function Lf(n,e){if(Number.isNaN(n.value))return Pe.noValueHere;if(e.says)return e.says(Math.round(n.value));let t=n.half*e.factor,i=n.value*e.factor;if(!(t>0))return yf(Kc(i,4),e.unit);let s=Math.max(0,1-Math.floor(Math.log10(t))),r=s>8||Math.abs(i)>=1e6?Kc(i,4):cs(xf(i,s));return yf(Pe.halfLevel(r,Kc(t,2)),e.unit)}function E0(n,e,t,i){let s=n.place.map((o,a)=>cs(xf(o+i.centre[a],2))).join(", "),r=Xc(n.part,n.cell);return[Lf(n,t),e,Pe.element(String(n.part.elements[n.cell])),r.length?r.join(", "):n.part.held.name,`(${s}) m`]}function A0(n,e,t){let i=Je("div",{class:"view-tip",hidden:""});n.element.append(i);let s=0,r=(u,h)=>{let f=t(u,h);if(i.hidden=!f,n.canvas.style.cursor=f?"crosshair":"grab",!f)return null;i.replaceChildren(Je("b",{},f[0]),...f.slice(1).map(y=>Je("span",{},y)));let{width:d,height:m}=n.size();return i.style.left=`${Math.max(4,u+16+i.offsetWidth>d?u-i.offsetWidth-12:u+16)}px`,i.style.top=`${Math.max(4,Math.min(h+14,m-i.offsetHeight-4))}px`,f},o=(u,h)=>{let f=r(u,h);f&&(e.textContent=f.join(" · "))},a=()=>{cancelAnimationFrame(s),i.hidden=!0},{canvas:l}=n;l.addEventListener("pointermove",u=>{if(cancelAnimationFrame(s),u.buttons||u.pointerType==="touch")return a();let{offsetX:h,offsetY:f}=u;s=requestAnimationFrame(()=>r(h,f))}),l.addEventListener("pointerleave",a),l.addEventListener("blur",a);let c={x:0,y:0};return l.addEventListener("pointerdown",({offsetX:u,offsetY:h})=>{c={x:u,y:h},l.focus({preventScroll:!0})}),l.addEventListener("click",({offsetX:u,offsetY:h})=>{Math.hypot(u-c.x,h-c.y)<5&&o(u,h)}),l.addEventListener("keydown",u=>{if(u.key==="Escape"&&a(),u.key!=="Enter")return;let h=n.places(1)[0];o(h.width/2,h.height/2)}),{hide:a}}async function T0(n,e,t,i){let s=kg(n),r=await Promise.all(n.parts.map((fe,Le)=>zg(n,Le,s))),o=m0(n),a=Vg(r,s),l=$g(s,a),c=qg(n,s),u=Zg(n,s,o,l),h=c0(s.diagonal),f=n0(r,s),d=r.map(w0),m=S0(n,r),y=[Tf(),Tf()],p={low:0,high:1},g=null,v=!1,T=()=>o.find(fe=>fe.name===u.field),S=()=>Zc(u.field),C=()=>({...s0(T()?.unit??"",Math.max(Math.abs(p.low),Math.abs(p.high))),says:S()?.words}),A=()=>S()??Hg(p),x=fe=>u.times[y.indexOf(fe)],E=()=>u.beside?y:y.slice(1),z=0,U=async()=>{let fe=++z,Le=await Promise.all(E().map(Mt=>Promise.all(d.map(N=>N(x(Mt))))));if(fe!==z)return;let Ee=f(u,Le),Qe=r.map(Mt=>Ee.flat().some(N=>N.sheet.part===Mt&&N.opacity>0)),mt=Qe.map((Mt,N)=>Mt||n.parts[N].kind==="rock"),wt=await Promise.all(E().map(Mt=>_0(n,r,Qe,mt,u.field,x(Mt),u.scale>0)));if(fe!==z)return;let ct=Rf(r,u);E().forEach((Mt,N)=>x0(Mt,Ee[N],wt[N],ct,h));let Xt=S(),ut=Xt?Wg(Xt):await m(u,E());if(fe!==z)return;p=ut??{low:0,high:1},p.high>p.low||(p={low:p.low,high:p.low+(Math.abs(p.low)||1)*1e-6}),g=Pf(E(),ct,u),v=E().some(Mt=>Mt.drawn.some(({layer:N,level:Me})=>N.opacity>0&&ct.includes(N.sheet.part)&&Me.some(($e,rt)=>rt%2===1&&!$e))),h.colours(A(),p),h.shared.deform.value=u.scale,u.cuts.forEach(({on:Mt,keep:N},Me)=>{h.planes.cutAt.value.setComponent(Me,ma(u,s,Me)),h.planes.cutKeep.value.setComponent(Me,Mt?N:0)});let{factor:Jt,unit:qt}=C();V=!0,pe.tell({low:p.low*Jt,high:p.high*Jt,unit:qt,coded:Xt!==null}),Y()},D=()=>{let fe=getComputedStyle(e),Le=wt=>fe.getPropertyValue(wt).trim()||"#808080",Ee=t.size(),Qe=C(),mt=(p.high-p.low)/500;return{width:Ee.width,height:Ee.height,ink:Le("--ink"),muted:Le("--muted"),paper:Le("--paper"),nothing:`#${new ht(Le("--paper")).lerp(new ht(Le("--ink")),.32).getHexString()}`,bar:T()&&{range:p,scheme:A(),shown:Qe,beyond:{below:!!g&&g.low<p.low-mt,above:!!g&&g.high>p.high+mt},nothing:v}||null,panels:t.places(E().length).map((wt,ct)=>({...wt,lines:H(E()[ct].time),flow:i0(n,s,u,E()[ct].time)})),camera:ke.camera,waves:n.waves}},H=fe=>{let Le=[T()?.label??"",n.times[fe].label];return S()&&n.parts.some(Ee=>Ee.fields.some(Qe=>Qe.name===u.field&&Qe.at==="points"))&&Le.push(Pe.worstOfFace),u.scale>0&&Le.push(Pe.deformedBy(String(u.scale))),n.parts.forEach((Ee,Qe)=>{let mt=u.shown[Qe]&&Qc(r[Qe],u.field),wt=Ee.fields.find(ct=>ct.name===u.field)?.blocks[fe];mt&&wt===null&&Le.push(Pe.leftOut(Ee.name)),u.shown[Qe]&&u.scale>0&&Ee.displacement[fe]===null&&Le.push(Pe.notMoved(Ee.name))}),Le},O=()=>{let{width:fe,height:Le}=t.places(E().length)[0];ke.aim(fe/Le)},I=0,V=!1,Y=()=>{if(cancelAnimationFrame(I),I=0,!V)return;let fe=t.size();O();let Le=D();h.shared.ink.value.set(Le.ink),h.shared.nothing.value.set(Le.nothing),h.shared.plainColour.value.set(Le.paper).lerp(h.shared.ink.value,.13),t.render(E().map(Qe=>Qe.scene),ke.camera,Le.paper);let Ee=t.over.getContext("2d");Ee.setTransform(fe.fine,0,0,fe.fine,0,0),Ee.clearRect(0,0,fe.width,fe.height),jc(Ee,Le)},k=()=>{I||(I=requestAnimationFrame(Y))},ae=(fe,Le)=>{let Ee=t.places(E().length),Qe=Ee.findIndex(ut=>fe>=ut.left&&fe<ut.left+ut.width&&Le>=ut.top&&Le<ut.top+ut.height);if(Qe<0)return null;let{left:mt,top:wt,width:ct,height:Xt}=Ee[Qe];return{panel:E()[Qe],x:2*(fe-mt)/ct-1,y:1-2*(Le-wt)/Xt}},$=(fe,Le)=>{let Ee=ae(fe,Le);return Ee&&Cf(Ee.panel,ke.camera,h,Ee.x,Ee.y)},J=(fe,Le)=>{let Ee=$(fe,Le);return Ee&&E0(Ee,T()?.label??"",C(),s)},ne=()=>{st.hide(),t.fit(u.beside),U().catch(()=>ge.textContent=Pe.unreadable)},he=()=>(Y(),v0(t.canvas,D(),ce())),ce=()=>{let fe=u.cuts.flatMap(({on:Ee,at:Qe},mt)=>Ee?[Pe.cutNamed(gf[mt],cs(Qe.toFixed(2)))]:[]),Le=n.parts.filter((Ee,Qe)=>u.shown[Qe]).map(Ee=>Ee.name);return[document.title,[T()?.label??"",...E().map(Ee=>n.times[Ee.time].label),...fe].join(" · "),Le.join(", ")]},j={changed:ne,look:fe=>ke.look(fe),picture:()=>{he().then(fe=>fe&&b0(fe))},factor:()=>C().factor},pe=Jg(n,s,u,o,c,j),ge=Je("p",{class:"view-says","aria-live":"polite"},Pe.hint),_e=[Pe.halfLevelNote,...n.notes].map(fe=>Je("p",{class:"note"},fe)),Se=Je("details",{class:"view-about"},Je("summary",{},Pe.about),..._e);e.replaceChildren(Kg(j),t.element,ge,pe.element,Se);let ke=Gg(t.canvas,s,a,l,k),st=A0(t,ge,J);t.fit(u.beside),O(),ke.look("oblique"),i.again=k,new ResizeObserver(()=>{t.fit(u.beside),k()}).observe(t.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",k),await U();let We=fe=>({part:fe.part.held.name,element:fe.part.elements[fe.cell],groups:Xc(fe.part,fe.cell),field:u.field,value:Number.isNaN(fe.value)?null:fe.value,unit:T()?.unit??"",halfLevel:fe.half,text:Lf(fe,C())});return{pick:(fe,Le)=>{let Ee=$(fe,Le);return Ee&&We(Ee)},show:async fe=>{kp(u,fe,n.parts.map(Le=>Le.name)),t.fit(u.beside),fe.look&&ke.look(fe.look),await U()},locate:fe=>{let Le=t.places(E().length),{left:Ee,top:Qe,width:mt,height:wt}=Le[Le.length-1],ct=y0(y[1],ke.camera,h,fe);return ct&&{x:Ee+(ct[0]+1)/2*mt,y:Qe+(1-ct[1])/2*wt}},fields:()=>o.map(fe=>fe.name),times:()=>n.times.map(fe=>fe.label),picture:he}}function C0(n){let e=Je("canvas",{tabindex:"0",role:"img","aria-label":Pe.canvas}),t=e.getContext("webgl2",{antialias:!0,alpha:!1,powerPreference:"high-performance"});if(!t)return null;qh(()=>{});let i=new Bc({canvas:e,context:t});i.autoClear=!1;let s=Je("canvas",{class:"view-over","aria-hidden":"true"}),r=Je("div",{class:"view-stage"},e,s),o=Je("p",{class:"view-message",role:"status"},Pe.lost);e.addEventListener("webglcontextlost",c=>{c.preventDefault(),r.before(o)}),e.addEventListener("webglcontextrestored",()=>{o.remove(),n()});let a={width:0,height:0,fine:1},l=()=>a.width<640;return{canvas:e,over:s,element:r,fit(c){let u=r.clientWidth||600,h=u<640?Math.min(u,.7*innerHeight):Math.min(.64*u,.8*innerHeight),f=Math.round(Math.max(280,h)*(c&&u<640?2:1)),d=Math.min(2,devicePixelRatio||1);u===a.width&&f===a.height&&d===a.fine||(a={width:u,height:f,fine:d},i.setPixelRatio(d),i.setSize(u,f,!1),e.style.height=s.style.height=`${f}px`,s.style.width=`${u}px`,s.width=Math.round(u*d),s.height=Math.round(f*d))},size:()=>a,places(c){let{width:u,height:h}=a;return Array.from({length:c},(f,d)=>l()?{left:0,top:d*h/c,width:u,height:h/c}:{left:d*u/c,top:0,width:u/c,height:h})},render(c,u,h){let f=this.places(c.length);i.setScissorTest(!0),i.setClearColor(new ht(h)),c.forEach((d,m)=>{let{left:y,top:p,width:g,height:v}=f[m],T=a.height-p-v;i.setViewport(y,T,g,v),i.setScissor(y,T,g,v),i.clear(),i.render(d,u)})}}}var R0=`.view { margin: 0 0 22px; }
.view-stage { position: relative; border: 1px solid var(--line); border-radius: 6px; overflow: hidden; background: var(--paper); }
.view-stage canvas { display: block; width: 100%; }
.view-stage canvas:focus-visible { outline: 2px solid var(--muted); outline-offset: -3px; }
.view-stage .view-over { position: absolute; inset: 0; pointer-events: none; }
.view-tip { position: absolute; z-index: 1; max-width: 280px; padding: 6px 9px; border: 1px solid var(--line); border-radius: 5px; background: var(--paper); color: var(--ink); font-size: 12.5px; line-height: 1.35; pointer-events: none; overflow-wrap: anywhere; box-shadow: 0 2px 8px #0003; }
.view-tip b { display: block; font-size: 14px; }
.view-tip span { display: block; color: var(--muted); }
.view-says { min-height: 1.4em; margin: 6px 0; color: var(--muted); font-size: 13px; overflow-wrap: anywhere; }
.view-message { padding: 18px; color: var(--muted); }
.view-tools { display: flex; flex-wrap: wrap; gap: 6px; margin: 0 0 8px; }
.view button { padding: 3px 10px; border: 1px solid var(--line); border-radius: 5px; background: var(--ground); color: var(--ink); font: inherit; font-size: 13px; cursor: pointer; }
.view button:hover { border-color: var(--muted); }
.view-controls { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 8px 26px; align-items: start; font-size: 13px; }
.view-controls details > summary { padding: 3px 0; cursor: pointer; font-weight: 600; }
.view-controls details details { margin: 0 0 4px 22px; }
.view-controls details details > summary { padding: 0; font-weight: 400; color: var(--muted); }
.view-controls .note { margin: 2px 0 4px; }
.view-row { display: flex; gap: 8px; align-items: center; margin: 4px 0; }
.view-row[hidden] { display: none; }
.view-row > span:first-child { flex: 0 0 92px; color: var(--muted); }
.view-indented { margin-left: 100px; }
.view-row > select, .view-slide > input { flex: 1 1 0; min-width: 0; }
.view-slide > output { flex: 0 0 64px; text-align: right; font-variant-numeric: tabular-nums; }
.view-limits > span:nth-of-type(2) { color: var(--muted); }
.view-row > input[type="number"] { width: 82px; }
.view-cut > input[type="range"] { flex: 1 1 0; min-width: 0; }
.view-cut > .view-check { flex: 0 0 38px; margin: 0; }
.view-check { display: flex; gap: 7px; align-items: baseline; margin: 3px 0; }
.view-about { margin-top: 10px; font-size: 13px; }
.view-about > summary { cursor: pointer; color: var(--muted); }
.view-check span { overflow-wrap: anywhere; }
.view select, .view input[type="number"] { padding: 2px 4px; border: 1px solid var(--line); border-radius: 4px; background: var(--paper); color: var(--ink); font: inherit; }
@media (max-width: 700px) {
  .view-controls { grid-template-columns: minmax(0, 1fr); gap: 4px; }
  .view-controls details { border-top: 1px solid var(--line); }
  .view-controls details details { border: 0; }
  .view-controls summary { padding: 7px 0; }
  .view-check { margin: 7px 0; }
}
@media print { #model-view { display: none; } }
`;var P0={pick:()=>null,locate:()=>null,fields:()=>[],times:()=>[],show:async()=>{},picture:async()=>null};function O1(){let n=Je("div",{id:"view"}),e=Je("section",{id:"model-view"},Je("h2",{},Pe.view),n),t=document.querySelector("header");return t?t.after(e):document.body.prepend(e),n}function I0(){let n=ba("view-data");if(!n)return;let e=document.getElementById("view")??O1();document.head.append(Je("style",{},R0)),e.classList.add("view");let t=a=>e.replaceChildren(Je("p",{class:"view-message",role:"status"},a)),i={again:()=>{}},s=C0(()=>i.again());if(!s||typeof DecompressionStream>"u"){t(Pe.noGraphics),Wa({...P0,ready:Promise.resolve(!1)});return}t(Pe.loading);let o=T0(n,e,s,i).then(a=>(Wa({...a,ready:o}),!0),()=>(t(Pe.unreadable),!1));Wa({...P0,ready:o})}Bp();I0();})();

//! Where in a file something can be switched.

use crate::At;
use proc_macro2::Span;
use std::collections::BTreeMap;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Arm, Block, Expr, Signature};

/// What can be switched, in bytes of the text.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// An operator between two operands, or with the second alone.
    Operator { left: Option<Range<usize>>, operator: Range<usize>, right: Range<usize> },
    /// The body of a function begins here.
    Body(usize),
    /// A condition of an arm.
    Guard(Range<usize>),
    /// An arm whose pattern ends here; its condition.
    Arm(usize, Option<Range<usize>>),
}

/// By genre and by where cargo-mutants says that it begins.
pub type Places = BTreeMap<(&'static str, At), Place>;

pub fn of(text: &str) -> syn::Result<Places> {
    let file = syn::parse_file(text)?;
    let mut seek = Seek::default();
    seek.visit_file(&file);
    Ok(seek.found)
}

#[derive(Default)]
struct Seek {
    found: Places,
}

fn at(span: Span) -> At {
    let start = span.start();
    At { line: start.line, column: start.column + 1 }
}

/// Whether a condition binds names, as parts of `&&` may.
fn binds(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

impl Seek {
    fn body(&mut self, signature: &Signature, block: &Block) {
        if signature.constness.is_some() {
            return;
        }
        if let Some(first) = block.stmts.first() {
            let span = first.span();
            self.found.insert(("FnValue", at(span)), Place::Body(span.byte_range().start));
        }
        self.visit_block(block);
    }
}

impl<'ast> Visit<'ast> for Seek {
    // What is known when the program is built asks nobody.
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}
    fn visit_expr_const(&mut self, _: &'ast syn::ExprConst) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_generics(&mut self, _: &'ast syn::Generics) {}
    fn visit_angle_bracketed_generic_arguments(&mut self, _: &'ast syn::AngleBracketedGenericArguments) {}
    fn visit_variant(&mut self, _: &'ast syn::Variant) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}

    fn visit_expr_repeat(&mut self, repeat: &'ast syn::ExprRepeat) {
        self.visit_expr(&repeat.expr);
    }

    fn visit_item_fn(&mut self, function: &'ast syn::ItemFn) {
        self.body(&function.sig, &function.block);
    }

    fn visit_impl_item_fn(&mut self, function: &'ast syn::ImplItemFn) {
        self.body(&function.sig, &function.block);
    }

    fn visit_trait_item_fn(&mut self, function: &'ast syn::TraitItemFn) {
        if let Some(block) = &function.default {
            self.body(&function.sig, block);
        }
    }

    fn visit_expr_binary(&mut self, binary: &'ast syn::ExprBinary) {
        if !binds(&binary.left) && !binds(&binary.right) {
            let [left, operator, right] =
                [binary.left.span(), binary.op.span(), binary.right.span()].map(|span| span.byte_range());
            let place = Place::Operator { left: Some(left), operator, right };
            self.found.insert(("BinaryOperator", at(binary.op.span())), place);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'ast syn::ExprUnary) {
        let [operator, right] = [unary.op.span(), unary.expr.span()].map(|span| span.byte_range());
        self.found
            .insert(("UnaryOperator", at(unary.op.span())), Place::Operator { left: None, operator, right });
        visit::visit_expr_unary(self, unary);
    }

    fn visit_arm(&mut self, arm: &'ast Arm) {
        let guard = arm.guard.as_ref().map(|(_, guard)| guard);
        if !guard.is_some_and(|guard| binds(guard)) {
            let range = guard.map(|guard| guard.span().byte_range());
            if let Some((guard, range)) = guard.zip(range.clone()) {
                self.found.insert(("MatchArmGuard", at(guard.span())), Place::Guard(range));
            }
            let place = Place::Arm(arm.pat.span().byte_range().end, range);
            self.found.insert(("MatchArm", at(arm.span())), place);
        }
        visit::visit_arm(self, arm);
    }
}

//! No vertex shader branches on numbers of the frame alone: Mesa's software driver compiles such a shader anew at every draw, which
//! takes seconds.

use std::collections::BTreeSet;

use naga::{AddressSpace, Arena, Block, Expression, Function, Handle, Module, ShaderStage, Statement};

use crate::shaders::{all, parsed};

/// What a value depends on.
#[derive(Clone, Copy, PartialEq)]
enum Depends {
    Nothing,
    Uniforms,
    /// A local variable as it is.
    Local,
    Vertex,
}

fn join(parts: impl IntoIterator<Item = Depends>) -> Depends {
    parts.into_iter().fold(Depends::Nothing, |all, part| match (all, part) {
        (Depends::Nothing, other) | (other, Depends::Nothing) => other,
        (Depends::Uniforms, Depends::Uniforms) => Depends::Uniforms,
        _ => Depends::Vertex,
    })
}

fn depends(module: &Module, expressions: &Arena<Expression>, of: Handle<Expression>) -> Depends {
    let on = |other: &Handle<Expression>| depends(module, expressions, *other);
    match &expressions[of] {
        Expression::Literal(_) | Expression::Constant(_) | Expression::ZeroValue(_) | Expression::Override(_) => {
            Depends::Nothing
        }
        Expression::GlobalVariable(variable) if module.global_variables[*variable].space == AddressSpace::Uniform => {
            Depends::Uniforms
        }
        Expression::LocalVariable(_) => Depends::Local,
        Expression::Load { pointer } => on(pointer),
        Expression::Access { base, index } => join([on(base), on(index)]),
        Expression::AccessIndex { base, .. } => on(base),
        Expression::Splat { value, .. } | Expression::Swizzle { vector: value, .. } => on(value),
        Expression::Compose { components, .. } => join(components.iter().map(on)),
        Expression::Unary { expr, .. } | Expression::As { expr, .. } => on(expr),
        Expression::Relational { argument, .. } => on(argument),
        Expression::Binary { left, right, .. } => join([on(left), on(right)]),
        Expression::Select { condition, accept, reject } => join([on(condition), on(accept), on(reject)]),
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            join([Some(arg), arg1.as_ref(), arg2.as_ref(), arg3.as_ref()].into_iter().flatten().map(on))
        }
        _ => Depends::Vertex,
    }
}

/// Whether a loop that ends by this condition turns as often as numbers of the frame say: one of them against a counter.
fn counts_to_uniform(module: &Module, expressions: &Arena<Expression>, condition: Handle<Expression>) -> bool {
    match &expressions[condition] {
        Expression::Unary { expr, .. } => counts_to_uniform(module, expressions, *expr),
        Expression::Binary { left, right, .. } => {
            let sides = [*left, *right].map(|side| depends(module, expressions, side));
            sides.contains(&Depends::Uniforms) && sides.contains(&Depends::Local)
        }
        _ => false,
    }
}

/// Conditions of branches on the frame's numbers alone in a block, by their expressions; and the functions that it calls.
fn search(
    module: &Module,
    function: &Function,
    block: &Block,
    found: &mut Vec<String>,
    calls: &mut BTreeSet<Handle<Function>>,
) {
    let expressions = &function.expressions;
    let name = function.name.as_deref().unwrap_or("the entry point");
    for statement in block {
        match statement {
            Statement::Block(inner) => search(module, function, inner, found, calls),
            Statement::If { condition, accept, reject } => {
                let ends_loop = [accept, reject].into_iter().any(|part| matches!(part.first(), Some(Statement::Break)));
                if depends(module, expressions, *condition) == Depends::Uniforms
                    || (ends_loop && counts_to_uniform(module, expressions, *condition))
                {
                    found.push(format!("{name}: {:?}", expressions[*condition]));
                }
                search(module, function, accept, found, calls);
                search(module, function, reject, found, calls);
            }
            Statement::Loop { body, continuing, break_if } => {
                if break_if.is_some_and(|condition| counts_to_uniform(module, expressions, condition)) {
                    found.push(format!("{name}: a loop"));
                }
                search(module, function, body, found, calls);
                search(module, function, continuing, found, calls);
            }
            Statement::Switch { cases, .. } => {
                cases.iter().for_each(|case| search(module, function, &case.body, found, calls));
            }
            Statement::Call { function, .. } => {
                calls.insert(*function);
            }
            _ => {}
        }
    }
}

#[test]
fn no_vertex_shader_branches_on_numbers_of_the_frame_alone() {
    let mut vertices = 0;
    for (file, source) in all() {
        let module = parsed(file, &source);
        for entry in module.entry_points.iter().filter(|entry| entry.stage == ShaderStage::Vertex) {
            vertices += 1;
            let (mut found, mut calls) = (Vec::new(), BTreeSet::new());
            search(&module, &entry.function, &entry.function.body, &mut found, &mut calls);
            let mut known = BTreeSet::new();
            while let Some(call) = calls.pop_first() {
                if known.insert(call) {
                    let function = &module.functions[call];
                    search(&module, function, &function.body, &mut found, &mut calls);
                }
            }
            assert!(found.is_empty(), "{file}, {}: {found:#?}", entry.name);
        }
    }
    assert!(vertices > 80, "{vertices} vertex shaders");
}

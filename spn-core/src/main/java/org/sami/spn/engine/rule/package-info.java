/**
 * The rules of the language, one class each: they change the state and tell effects. Used by the engine alone.
 *
 * <p>Belongs here: when a transition is looked at, enabled and fired, and what follows from it. Does not belong here: bytes,
 * answers to questions from outside. Knows {@code state} and {@code net}.
 *
 * <p>Read {@code FiringAgenda}, {@code Enabling}, {@code Selection}, {@code Firing}, {@code Visits}, {@code Routing}, then the rest in
 * any order. A rule gets those that it uses; only the rules of {@code MissionRules} know all of one another, as one ends what another
 * began.
 */
@NullMarked
package org.sami.spn.engine.rule;

import org.jspecify.annotations.NullMarked;

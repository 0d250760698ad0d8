/**
 * Trying the plan that is written: on the engine itself, step by step and back, with robots and an operator that are not real; keeping runs as
 * the plan's test cases, running those and seeing what they never visit. What a step is stands in {@code org.sami.spn.stepping}.
 */
@NullMarked
package org.sami.dreamm.tryout;

import org.jspecify.annotations.NullMarked;

/**
 * The course inside DREAMM: where a learner is, what was answered, the jobs' plans, and the window in the mode of a lesson. What is taught and how it is graded is
 * data of the module lessons. Models without Swing; views stand in {@code view}.
 */
@NullMarked
package org.sami.dreamm.learn;

import org.jspecify.annotations.NullMarked;

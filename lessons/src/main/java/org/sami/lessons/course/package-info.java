/** The course as data: lessons, steps, quizzes, terms, and the reading of their files. */
@NullMarked
package org.sami.lessons.course;

import org.jspecify.annotations.NullMarked;

/** Grading of jobs: by what a plan does on the engine and by what it uses. */
@NullMarked
package org.sami.lessons.job;

import org.jspecify.annotations.NullMarked;

/** Commands about the course: its lessons, and the grading of jobs. */
@NullMarked
package org.sami.crw.cli.lesson;

import org.jspecify.annotations.NullMarked;

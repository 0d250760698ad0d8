/** What can be wrong with the content of a course, found before a learner does. */
@NullMarked
package org.sami.lessons.check;

import org.jspecify.annotations.NullMarked;

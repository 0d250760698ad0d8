/** What learners have done, kept in a file each. */
@NullMarked
package org.sami.lessons.progress;

import org.jspecify.annotations.NullMarked;

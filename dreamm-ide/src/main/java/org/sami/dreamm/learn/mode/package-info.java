/** What of the window a lesson has: a profile of its panels, commands and fields (thesis, appendix .4.1, lesson modes). */
@NullMarked
package org.sami.dreamm.learn.mode;

import org.jspecify.annotations.NullMarked;

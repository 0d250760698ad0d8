/** What of the window a lesson has: a profile and a domain with the words introduced so far (thesis, appendix .4.1, lesson modes). */
@NullMarked
package org.sami.dreamm.learn.mode;

import org.jspecify.annotations.NullMarked;

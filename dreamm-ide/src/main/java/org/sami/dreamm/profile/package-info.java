/** What of the window an author is given: all of it, or what a profile's file leaves (thesis, appendix .4.1: lesson modes). */
@NullMarked
package org.sami.dreamm.profile;

import org.jspecify.annotations.NullMarked;

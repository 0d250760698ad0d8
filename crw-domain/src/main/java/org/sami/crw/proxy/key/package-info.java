/** The keys of this base: what is known of each, withdrawing, and taking them to a second laptop. For the command and for windows. */
@NullMarked
package org.sami.crw.proxy.key;

import org.jspecify.annotations.NullMarked;

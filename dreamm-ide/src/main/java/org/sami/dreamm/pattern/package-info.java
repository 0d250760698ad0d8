/** The commands that draw patterns on a selection: previewed on the net, then drawn as one edit. What a pattern is stands in {@link org.sami.spn.pattern}. */
@NullMarked
package org.sami.dreamm.pattern;

import org.jspecify.annotations.NullMarked;

/** The command that suggests requirements at the selected edge: searched in the background, previewed on the net, applied as one edit. How they are found stands in {@link org.sami.spn.suggestion}. */
@NullMarked
package org.sami.dreamm.suggestion;

import org.jspecify.annotations.NullMarked;

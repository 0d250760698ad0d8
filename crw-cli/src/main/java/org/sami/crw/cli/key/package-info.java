/** {@code crw keys}: the keys of this base, and the boats that are paired with it. */
@NullMarked
package org.sami.crw.cli.key;

import org.jspecify.annotations.NullMarked;

/** Commands about a pair of bases, of which one replicates the session of the other; and taking a session over. */
@NullMarked
package org.sami.crw.cli.pair;

import org.jspecify.annotations.NullMarked;

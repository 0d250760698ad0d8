/** What a domain declares for authors: groups of events for the palette, and the sequences of vertices that the event wizard adds (thesis 5.2). */
@NullMarked
package org.sami.spn.sequence;

import org.jspecify.annotations.NullMarked;

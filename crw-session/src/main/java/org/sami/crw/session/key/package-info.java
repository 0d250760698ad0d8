/** Pairing and keys as a person does them at a window: what is typed is judged, what waits is done by threads of its own. No window, no boat's proxy. */
@NullMarked
package org.sami.crw.session.key;

import org.jspecify.annotations.NullMarked;

/** What a base does with another base's session while it waits to go on with it. */
@NullMarked
package org.sami.crw.session.standby;

import org.jspecify.annotations.NullMarked;

/**
 * The base's side of the link to one boat: hello and heartbeat, whether it is lost, and requests that are sent until they are answered.
 *
 * <p>Does not belong here: messages and their bytes ({@code org.sami.boat.link}), sockets ({@code tcp}), what is asked ({@code
 * execution}).
 */
@NullMarked
package org.sami.crw.proxy.link;

import org.jspecify.annotations.NullMarked;

/**
 * What reaches vehicles of other makers and speaks the boat link for them, so that a base commands them like its own boats.
 *
 * <p>Only the interfaces that a base uses. Not here: implementations of such a protocol.
 */
@NullMarked
package org.sami.crw.proxy.gateway;

import org.jspecify.annotations.NullMarked;

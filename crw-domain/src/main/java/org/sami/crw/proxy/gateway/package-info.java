/**
 * What reaches vehicles of other makers and speaks the boat link for them, so that a base commands them like its own boats.
 *
 * <p>Here is only what a base knows of it. Not here: any such protocol.
 */
@NullMarked
package org.sami.crw.proxy.gateway;

import org.jspecify.annotations.NullMarked;

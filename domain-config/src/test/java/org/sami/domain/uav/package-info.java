/** A tiny second domain, aircraft instead of boats: the words of docs/writing-a-domain.md, tried. */
package org.sami.domain.uav;

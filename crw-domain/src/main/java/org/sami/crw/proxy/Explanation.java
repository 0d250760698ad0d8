package org.sami.crw.proxy;

/**
 * Why a boat moves or does not, in words for the operator.
 *
 * @param shouldMove whether the boat is expected to be under way now
 */
public record Explanation(boolean shouldMove, String text) {}

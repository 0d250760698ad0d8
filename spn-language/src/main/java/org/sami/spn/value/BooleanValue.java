package org.sami.spn.value;

/** A truth value. */
public record BooleanValue(boolean value) implements Value {}

package org.sami.spn.value;

/** A whole number. */
public record IntegerValue(long value) implements Value {}

package org.sami.figures;

import java.util.Map;

/**
 * One measured number.
 *
 * @param name of the benchmark
 * @param params what it was measured with
 * @param error how far single measurements were off, in the same unit; 0 where there was one
 */
public record Figure(String name, Map<String, Integer> params, double value, String unit, double error) {}

package org.sami.crw.sim.experiment;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * An experiment in portions that several machines can divide, numbered from 0 in the order in which they are begun. What comes of a portion is text that holds every number exactly, so
 * tables are equal whoever made which.
 *
 * @param <R> a row of the experiment's file
 */
public interface Portions<R> {
    /** How many there are. */
    int count();

    /** Makes one; empty where it was stopped. A run that breaks gives a result that says so. */
    Optional<String> make(int portion, BooleanSupplier stop);

    /**
     * Reads what came of it.
     *
     * @param results of portions, by their numbers; one without a result has no rows
     * @param givenUp why portions will never have a result, by their numbers: they are failed runs
     * @return rows in the order of the experiment's file
     */
    List<R> rows(Map<Integer, String> results, Map<Integer, String> givenUp);
}

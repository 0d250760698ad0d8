package org.sami.crw.sim.experiment.table;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The experiments that ship with the program: tables of the thesis. */
public final class ThesisTables {
    /** The thesis's tables, by their numbers. */
    public static final List<String> NAMES = List.of("7.1", "7.2", "7.3", "7.4", "8.1");

    private ThesisTables() {}

    /**
     * The text of an experiment's file.
     *
     * @throws IllegalArgumentException where there is none of that name
     */
    public static String text(String name) {
        try (InputStream file =
                ThesisTables.class.getResourceAsStream("/org/sami/crw/sim/experiment/table-" + name + ".json")) {
            if (file == null) {
                throw new IllegalArgumentException("no table " + name);
            }
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

package org.sami.crw.gui.decision;

import java.util.List;

/** The boats chosen for an answer, on the map or in the panel. On the event thread. */
public interface BoatPick {
    /** Those that are offered. */
    List<String> offered();

    /** Those that are chosen now. */
    List<String> chosen();

    /** Chooses one, or leaves one out that is chosen. */
    void toggle(String boat);

    /** Chooses these of the offered ones, and no others. */
    void only(List<String> boats);
}

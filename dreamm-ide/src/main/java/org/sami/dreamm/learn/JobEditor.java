package org.sami.dreamm.learn;

import java.nio.file.Path;
import java.util.Set;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;

/** The editor next to a lesson, as jobs use it. On the event thread. */
public interface JobEditor {
    /**
     * Opens a project that is kept in a file after each edit.
     *
     * @param file need not be there yet
     * @param begin is opened where there is no file, or one that cannot be read; that is set aside and named
     */
    void open(Path file, Project begin);

    /** Puts another project into the place of the one that is open, as an edit that can be taken back. */
    void replace(String label, Project by);

    /** The project as it is now. */
    Project project();

    /** Shows a plan, and elements of it. */
    void show(String plan, Set<String> elements);

    /**
     * Plays a run of the open project.
     *
     * @return whether the window can: a lesson's mode may have nothing to try plans with
     */
    boolean play(String plan, TestCase run);

    /** Shows the learner's plan and a right one on one net, with what differs in words. */
    void compareWithSolution(Plan solution);
}

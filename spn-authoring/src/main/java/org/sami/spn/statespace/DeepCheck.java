package org.sami.spn.statespace;

import java.util.List;
import org.sami.spn.finding.Advice;

/** A check that takes a while: it runs the plan, as far as its request says. Without state: one object may run for several plans at once. */
public interface DeepCheck {
    /** A stable id in kebab-case. */
    String id();

    /** What it is called, in a few words. */
    String title();

    /** One sentence: what it finds, and what it cannot know. */
    String help();

    /** Why each of its findings matters and how it is mended: one for each code that it reports. */
    List<Advice> advice();

    /**
     * Runs on the caller's thread.
     *
     * @param watch receives how far it is, and asked whether to stop
     * @throws IllegalArgumentException with the reason, if the plan cannot start
     */
    DeepResult run(DeepRequest request, SearchWatch watch);
}

package org.sami.dreamm.help;

import java.util.Optional;

/** A component that shows something the domain has help on; that of the innermost one around the focus is shown. */
public interface Explained {
    /** What is explained here at the moment; empty where nothing is. */
    Optional<HelpTopic> help();
}

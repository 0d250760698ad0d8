package org.sami.dreamm.learn.view;

import java.util.Optional;
import org.sami.dreamm.learn.PictureRun;

/** What the commands of the course have the panel do. */
interface LearnActions {
    /** The run in the picture that is shown; empty where nothing runs. */
    Optional<PictureRun> run();

    /** The run was moved. */
    void ran();

    /** Opens the list of lessons and steps. */
    void openContents();

    /** Opens the glossary. */
    void openGlossary();
}

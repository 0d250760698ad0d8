package org.sami.dreamm.learn.view;

import java.util.Optional;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.PictureRun;

/** What the commands of the course have the panel do. */
interface LearnActions {
    /** The run in the picture that is shown; empty where nothing runs. */
    Optional<PictureRun> run();

    /** The run was moved. */
    void ran();

    /** The job of the step; empty before the window has an editor. */
    Optional<JobModel> jobs();

    /** Plays the run of a job that went wrong. */
    void playFailure();

    /** Opens the list of lessons and steps. */
    void openContents();

    /** Opens the glossary. */
    void openGlossary();
}

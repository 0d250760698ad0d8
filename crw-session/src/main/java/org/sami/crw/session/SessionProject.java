package org.sami.crw.session;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.sami.crw.session.archive.SavedGlobals;
import org.sami.session.api.RefusedException;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * The project of a session: the plans that missions start from, and what global variables hold at first. Files are read, checked and
 * written on a thread of the session's; results arrive as those of all its operations do. From any thread.
 */
public final class SessionProject {
    private final SessionEngine engine;
    private final ProjectFiles projects;
    private final Executor files;

    /**
     * The project of one session.
     *
     * @param files reads and writes files
     */
    SessionProject(SessionEngine engine, ProjectFiles projects, Executor files) {
        this.engine = engine;
        this.projects = projects;
        this.files = files;
    }

    /**
     * Loads a project while missions run: those keep the plans with which they started, missions that start from now on have
     * these. Its plans are checked on a thread of the session's; one with an error is refused, and nothing changes.
     *
     * @return the session's number for the project: that with which it began is 1
     */
    public CompletionStage<Integer> load(Project project) {
        return post(engine.replies().on(files, () -> projects.checked(project)));
    }

    /** Reads a project's file or folder on a thread of the session's, and loads it as {@link #load(Project)} does. */
    public CompletionStage<Integer> load(Path file) {
        return post(engine.replies().on(files, () -> projects.checked(projects.read(file))));
    }

    private CompletionStage<Integer> post(CompletionStage<String> document) {
        return document.thenCompose(text -> engine.posted().post(new Input.LoadProject(text), SessionProject::loaded));
    }

    private static int loaded(List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ProjectLoaded project) {
                return project.version();
            }
        }
        throw new RefusedException("the project is not loaded");
    }

    /**
     * Makes the values that global variables have now their initial ones in a project's file or folder, which is written on a thread of
     * the session's; everything else in it stays.
     *
     * @return what changed in the file; a refusal where it cannot be read or written, or gives a global another type
     */
    public CompletionStage<SavedGlobals> saveGlobals(Path file) {
        return engine.ask(EngineView::globals)
                .thenCompose(values -> engine.replies().on(files, () -> projects.save(values, file)));
    }

    /**
     * Writes the newest project, with the values that its global variables have now, to a new file, on a thread of the session's. One
     * that is there already is refused.
     */
    public CompletionStage<Void> save(Path file) {
        return engine.ask(view -> ProjectFiles.withValues(view.project(), view.globals()))
                .thenCompose(project -> engine.replies().on(files, () -> projects.saveNew(project, file)));
    }
}

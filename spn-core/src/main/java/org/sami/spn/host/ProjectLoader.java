package org.sami.spn.host;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.engine.EngineView;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Loads projects into a hosted session, beside the missions that run (docs/decisions 0176). A project is checked first; one with
 * errors is not posted. May be called from any thread.
 */
public final class ProjectLoader {
    /** The code of what keeps a project, whose plans may be good in themselves, from being loaded into this session. */
    public static final String REFUSED = "E-LOAD";

    private final EngineHost host;
    private final Vocabulary vocabulary;

    /**
     * A loader for a session.
     *
     * @param vocabulary the session's, which its engine has
     */
    public ProjectLoader(EngineHost host, Vocabulary vocabulary) {
        this.host = Objects.requireNonNull(host, "host");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /**
     * What came of a load.
     *
     * @param version the session's number for the project; empty where it was refused, and then nothing has changed
     * @param findings of the project's checks; where it was refused, an error among them says why
     */
    public record Loaded(OptionalInt version, List<Finding> findings) {
        public Loaded {
            Objects.requireNonNull(version, "version");
            findings = List.copyOf(findings);
        }
    }

    /** Reads and checks a file or folder on the calling thread, and loads it. */
    public CompletableFuture<Loaded> load(Path path) {
        return load(new ProjectReader(vocabulary).readAndCheck(path));
    }

    /** Checks a project on the calling thread, and loads it. */
    public CompletableFuture<Loaded> load(Project project) {
        return load(new Reading<>(Optional.of(project), PlanChecks.check(project, vocabulary)));
    }

    /**
     * Loads a project that was read and checked.
     *
     * @return completed when the load is durable, on the engine's thread, or at once where the project is refused, also since the
     *     host fails before
     */
    public CompletableFuture<Loaded> load(Reading<Project> checked) {
        if (checked.hasErrors() || checked.result().isEmpty()) {
            return CompletableFuture.completedFuture(new Loaded(OptionalInt.empty(), checked.findings()));
        }
        Reading<String> document = document(checked.result().get());
        return document.result()
                .map(text -> post(new Input.LoadProject(text), checked.findings()))
                .orElseGet(() -> CompletableFuture.completedFuture(
                        refused(checked.findings(), document.findings().get(0))));
    }

    /** The project's document, if it says the same in the words of this session. */
    private Reading<String> document(Project project) {
        try {
            String text = new ProjectWriter(vocabulary).text(project);
            if (new ProjectReader(vocabulary).read(text).result().equals(Optional.of(project))) {
                return new Reading<>(Optional.of(text), List.of());
            }
            return new Reading<>(Optional.empty(), List.of(error("is of another vocabulary than the session's")));
        } catch (IllegalArgumentException unknownWord) {
            return new Reading<>(
                    Optional.empty(),
                    List.of(error("is of another vocabulary than the session's: " + unknownWord.getMessage())));
        }
    }

    private CompletableFuture<Loaded> post(Input.LoadProject load, List<Finding> findings) {
        CompletableFuture<Loaded> loaded = new CompletableFuture<>();
        AtomicReference<Registration> registration = new AtomicReference<>();
        registration.set(host.addListener(new HostListener() {
            @Override
            public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
                if (input == load) {
                    loaded.complete(outcome(effects, findings));
                }
            }

            @Override
            public void onFailed(HostStatus status) {
                loaded.complete(refused(findings, error("is not loaded: " + status.whole())));
            }
        }));
        CompletableFuture<Loaded> heard =
                loaded.whenComplete((done, fault) -> registration.get().close());
        if (!host.post(load)) {
            loaded.complete(refused(findings, error("comes too late: the session has ended")));
        }
        return heard;
    }

    private static Loaded outcome(List<Effect> effects, List<Finding> findings) {
        String reason = "";
        for (Effect effect : effects) {
            if (effect instanceof Effect.ProjectLoaded loaded) {
                return new Loaded(OptionalInt.of(loaded.version()), findings);
            }
            if (effect instanceof Effect.Noted noted && noted.kind() == NoteKind.REJECTED_INPUT) {
                reason = noted.message(); // the last is the load's: what was due before it comes first
            }
        }
        return refused(findings, Finding.error(REFUSED, "", reason));
    }

    private static Loaded refused(List<Finding> findings, Finding why) {
        List<Finding> all = new ArrayList<>(findings);
        all.add(why);
        return new Loaded(OptionalInt.empty(), all);
    }

    private static Finding error(String why) {
        return Finding.error(REFUSED, "", "The project " + why);
    }
}

package org.sami.dreamm.issues;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.function.LongSupplier;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.analysis.LiveChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;

/**
 * The findings about a document, checked off the event thread after each change. While one version is checked, later ones wait and only the
 * newest is checked next. Its findings belong to the owner's thread.
 */
public final class LiveFindings {
    private final ProjectDocument document;
    private final Executor worker;
    private final Executor owner;
    private final LongSupplier clockNs;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<LiveChecks> checks = Optional.empty();
    private Project shown;
    private List<Finding> findings = List.of();
    private boolean checking;
    private boolean opened;
    private long changedNs;
    private long tookNs;

    /**
     * Findings of a document, which is checked at once.
     *
     * @param worker checks, one version after another
     * @param owner the thread of the document and of the listeners
     * @param clockNs a monotonic clock in nanoseconds
     */
    public LiveFindings(ProjectDocument document, Executor worker, Executor owner, LongSupplier clockNs) {
        this.document = Objects.requireNonNull(document, "document");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        this.clockNs = Objects.requireNonNull(clockNs, "clockNs");
        shown = document.project();
        document.addListener(this::changed);
        begin();
    }

    private void changed(DocumentChange change) {
        opened |= change.isOpened();
        if (!checking) {
            begin();
        }
    }

    private void begin() {
        checking = true;
        changedNs = clockNs.getAsLong();
        Project project = document.project();
        Optional<LiveChecks> from = opened ? Optional.empty() : checks;
        opened = false;
        worker.execute(() -> {
            LiveChecks next =
                    from.map(old -> old.after(project)).orElseGet(() -> LiveChecks.of(project, document.vocabulary()));
            owner.execute(() -> checked(next));
        });
    }

    @SuppressWarnings("ReferenceEquality") // edits make other objects: the same one is the same version
    private void checked(LiveChecks next) {
        checks = Optional.of(next);
        shown = next.project();
        findings = next.findings();
        tookNs = clockNs.getAsLong() - changedNs;
        checking = false;
        if (shown != document.project()) {
            begin();
        }
        listeners.forEach(Runnable::run);
    }

    /** The findings about {@link #project}, in the order of the document. */
    public List<Finding> findings() {
        return findings;
    }

    /** The version of the project that the findings are about; the document's may be newer while {@link #isChecking}. */
    public Project project() {
        return shown;
    }

    /** Whether a newer version is being checked. */
    public boolean isChecking() {
        return checking;
    }

    /** How long the findings came after the change that they are about, in nanoseconds. */
    public long tookNs() {
        return tookNs;
    }

    /** Tells somebody on the owner's thread when there are other findings. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}

package org.sami.dreamm.query;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.tryout.KeptResults;
import org.sami.dreamm.tryout.NetChanges;
import org.sami.dreamm.tryout.RunContent;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;

/**
 * The queries of the open plan with their last answers, each for what the plan was then: gone when it runs otherwise, and back when a change is undone. They are answered off the owner's thread, to which all else
 * belongs.
 */
public final class QueryAnswers {
    private static final Duration LONGEST = Duration.ofMinutes(1);
    private static final int PART_OF_MEMORY = 4;
    private static final int MOST_KEPT = 500;

    private final ProjectDocument document;
    private final EditorState editor;
    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final KeptResults<Asked, PlanQueryAnswer> answers = new KeptResults<>(MOST_KEPT);
    private Optional<RunContent> content = Optional.empty();
    private Optional<AtomicBoolean> cancelled = Optional.empty();
    private String message = "";

    private record Asked(RunContent content, PlanQuery query) {}

    /** Nothing is asked yet. */
    public QueryAnswers(ProjectDocument document, EditorState editor, Executor worker, Executor owner) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        document.addListener((DocumentChange change) -> {
            if (NetChanges.in(change)) {
                content = Optional.empty();
                message = "";
            }
            tell();
        });
        editor.addListener(new EditorListener() {
            @Override
            public void planOpened() {
                content = Optional.empty();
                message = "";
                tell();
            }
        });
    }

    /** The queries in the order of the plan, with what is known of each. */
    List<QueryRow> rows() {
        RunContent now = content();
        return queries().stream()
                .map(query -> new QueryRow(query, answers.find(new Asked(now, query))))
                .toList();
    }

    /** What the open plan runs now. */
    private RunContent content() {
        RunContent now = content.orElseGet(
                () -> RunContent.of(document.project(), editor.planId().orElse("")));
        content = Optional.of(now);
        return now;
    }

    /** The queries of the open plan. */
    List<PlanQuery> queries() {
        return editor.plan().map(Plan::queries).orElse(List.of());
    }

    boolean isRunning() {
        return cancelled.isPresent();
    }

    /** How it stands, in one sentence; empty text where nothing was asked. */
    String message() {
        return message;
    }

    /**
     * Answers queries of the open plan, one after another. Where some are being answered, nothing happens.
     *
     * @param robots names of those that the plan has at its start
     */
    void ask(List<PlanQuery> queries, List<String> robots) {
        Optional<String> plan = editor.planId();
        if (isRunning() || plan.isEmpty()) {
            return;
        }
        AtomicBoolean stop = new AtomicBoolean();
        cancelled = Optional.of(stop);
        message = "Asking…";
        RunContent of = content();
        PlanNetRequest request = new PlanNetRequest(document.project(), document.vocabulary(), plan.get(), robots);
        worker.execute(() -> {
            try {
                answer(request, queries, stop, of);
            } finally {
                owner.execute(() -> ended(stop));
            }
        });
        tell();
    }

    private void answer(PlanNetRequest request, List<PlanQuery> queries, AtomicBoolean stop, RunContent of) {
        SearchBudget budget =
                new SearchBudget(SearchBudget.MOST_STATES, Runtime.getRuntime().maxMemory() / PART_OF_MEMORY, LONGEST);
        try {
            PlanQueries net = new PlanQueries(PlanNet.smallest(request), budget, watch(stop));
            for (PlanQuery query : queries) {
                if (stop.get()) {
                    return;
                }
                PlanQueryAnswer answer = net.answer(query);
                owner.execute(() -> answered(answer, of));
            }
        } catch (PlanNetTooLargeException | IllegalArgumentException refused) {
            String why = "unknown: " + refused.getMessage();
            queries.forEach(query -> owner.execute(
                    () -> answered(PlanQueryAnswer.without(query, PlanQueryAnswer.Result.OPEN, why), of)));
        }
    }

    private GraphWatch watch(AtomicBoolean stop) {
        return new GraphWatch() {
            @Override
            public void looked(int states, int waiting) {
                owner.execute(() -> {
                    if (isRunning()) {
                        message = states + " states looked at, " + waiting + " known and waiting";
                        tell();
                    }
                });
            }

            @Override
            public boolean isCancelled() {
                return stop.get();
            }
        };
    }

    /** Keeps an answer for what the plan was when it was asked. */
    private void answered(PlanQueryAnswer answer, RunContent of) {
        answers.keep(new Asked(of, answer.query()), answer);
        tell();
    }

    private void ended(AtomicBoolean stop) {
        cancelled = Optional.empty();
        List<QueryRow> rows = rows();
        message = stop.get()
                ? "Stopped"
                : rows.stream().filter(QueryRow::isGood).count() + " as expected, "
                        + rows.stream().filter(QueryRow::isBad).count() + " not, of " + rows.size();
        tell();
    }

    /** Stops what is searched; what was answered until then stays. */
    void cancel() {
        cancelled.ifPresent(stop -> stop.set(true));
    }

    /** Tells somebody when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}

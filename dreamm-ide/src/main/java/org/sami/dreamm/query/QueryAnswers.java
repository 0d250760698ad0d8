package org.sami.dreamm.query;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.tryout.NetChanges;
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
 * The queries of the open plan with their last answers, which are forgotten when a plan runs otherwise. They are answered off the owner's thread, to which all else
 * belongs.
 */
public final class QueryAnswers {
    private static final Duration LONGEST = Duration.ofMinutes(1);
    private static final int PART_OF_MEMORY = 4;

    private final ProjectDocument document;
    private final EditorState editor;
    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final Map<Asked, PlanQueryAnswer> answers = new HashMap<>();
    private Optional<AtomicBoolean> cancelled = Optional.empty();
    private int version;
    private String message = "";

    private record Asked(String plan, PlanQuery query) {}

    /** Nothing is asked yet. */
    public QueryAnswers(ProjectDocument document, EditorState editor, Executor worker, Executor owner) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        document.addListener((DocumentChange change) -> {
            if (NetChanges.in(change)) {
                version++;
                answers.clear();
                message = "";
            }
            tell();
        });
        editor.addListener(new EditorListener() {
            @Override
            public void planOpened() {
                message = "";
                tell();
            }
        });
    }

    /** The queries in the order of the plan, with what is known of each. */
    List<QueryRow> rows() {
        String plan = editor.planId().orElse("");
        return queries().stream()
                .map(query -> new QueryRow(query, Optional.ofNullable(answers.get(new Asked(plan, query)))))
                .toList();
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
        int of = version;
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

    private void answer(PlanNetRequest request, List<PlanQuery> queries, AtomicBoolean stop, int of) {
        SearchBudget budget =
                new SearchBudget(SearchBudget.MOST_STATES, Runtime.getRuntime().maxMemory() / PART_OF_MEMORY, LONGEST);
        try {
            PlanQueries net = new PlanQueries(PlanNet.smallest(request), budget, watch(stop));
            for (PlanQuery query : queries) {
                if (stop.get()) {
                    return;
                }
                PlanQueryAnswer answer = net.answer(query);
                owner.execute(() -> answered(request.plan(), answer, of));
            }
        } catch (PlanNetTooLargeException | IllegalArgumentException refused) {
            String why = "unknown: " + refused.getMessage();
            queries.forEach(query -> owner.execute(() ->
                    answered(request.plan(), PlanQueryAnswer.without(query, PlanQueryAnswer.Result.OPEN, why), of)));
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

    /** Keeps an answer, unless the plan is another one by now. */
    private void answered(String plan, PlanQueryAnswer answer, int of) {
        if (of == version) {
            answers.put(new Asked(plan, answer.query()), answer);
            tell();
        }
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

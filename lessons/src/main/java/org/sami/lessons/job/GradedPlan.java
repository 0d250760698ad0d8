package org.sami.lessons.job;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** A learner's plan while it is graded: what it is made of, and its hidden cases, each run when it is first asked for. */
final class GradedPlan implements JobFacts {
    private final Job job;
    private final Vocabulary vocabulary;
    private final PlanStructure structure;
    private final List<Finding> findings;
    private final Optional<Engine> engine;
    private final Map<String, CaseRun> right;
    private final BooleanSupplier isCancelled;
    private final Map<String, CaseOutcome> outcomes = new LinkedHashMap<>();

    /**
     * A plan.
     *
     * @param runnable the project that is run; empty where errors keep it from that
     * @param right how each case goes with the solution
     */
    GradedPlan(
            Job job,
            Project project,
            Plan plan,
            Optional<Project> runnable,
            List<Finding> findings,
            Map<String, CaseRun> right,
            Vocabulary vocabulary,
            BooleanSupplier isCancelled) {
        this.job = job;
        this.vocabulary = vocabulary;
        structure = new PlanStructure(project, plan, vocabulary);
        this.findings = findings;
        engine = runnable.map(one -> new Engine(vocabulary, one, ScriptedWorld.MOST_FIRINGS));
        this.right = right;
        this.isCancelled = isCancelled;
    }

    @Override
    public PlanStructure structure() {
        return structure;
    }

    @Override
    public List<Finding> findings() {
        return findings;
    }

    @Override
    public Optional<CaseOutcome> outcome(String name) {
        Optional<JobCase> wanted = job.caseNamed(name);
        if (engine.isEmpty() || wanted.isEmpty()) {
            return Optional.empty();
        }
        CaseOutcome known = outcomes.get(name);
        if (known == null) {
            CaseRun run = ScriptedWorld.run(engine.get(), job.plan(), wanted.get(), isCancelled);
            CaseRun solved = right.get(name);
            known = CaseOutcome.of(wanted.get(), run, solved == null ? run : solved, new TraceWords(vocabulary));
            outcomes.put(name, known);
        }
        return Optional.of(known);
    }

    /** The first case that did not go as with the solution; all are run until then. */
    Optional<CaseOutcome> firstDifferent() {
        return job.cases().stream()
                .flatMap(one -> outcome(one.name()).stream())
                .filter(outcome -> !outcome.isSame())
                .findFirst();
    }
}

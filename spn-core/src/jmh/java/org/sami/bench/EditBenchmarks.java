package org.sami.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.sami.spn.analysis.LiveChecks;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Project;

/** What findings cost after one edit of a plan: of the whole shipped library again, and of what the edit concerns. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@State(Scope.Thread)
public class EditBenchmarks {
    private final DomainLibrary library = DomainLibrary.fromFolder(
                    Path.of("domain-config/src/main/resources/org/sami/domain/crw"))
            .orThrow();
    private final LiveChecks before = LiveChecks.of(library.combined(), library.vocabulary());
    private final Project edited = edited(library.combined(), library);
    private LiveChecks live = before;
    private boolean there;

    private static Project edited(Project project, DomainLibrary library) {
        InputEventSpec more = project.plan("clv").orElseThrow().transitions().stream()
                .flatMap(t -> t.inputs().stream())
                .findFirst()
                .orElseThrow()
                .withId("one-more");
        String transition =
                project.plan("clv").orElseThrow().transitions().get(0).id();
        return new EventEdit.AddInput("clv", transition, more)
                .apply(project, library.vocabulary())
                .project()
                .orElseThrow();
    }

    /** Microseconds for all plans. */
    @Benchmark
    public List<Finding> fullCheck() {
        return PlanChecks.check(edited, library.vocabulary());
    }

    /** Microseconds for the plan that an edit changed, there and back in turn. */
    @Benchmark
    public List<Finding> liveCheck() {
        there = !there;
        live = live.after(there ? edited : before.project());
        return live.findings();
    }
}

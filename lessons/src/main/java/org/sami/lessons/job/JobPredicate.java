package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.spn.model.Plan;

/** Something that is so of a plan, or of its runs, or is not so (docs/writing-a-lesson.md, A job). */
public sealed interface JobPredicate {
    /** Whether it is so. */
    boolean holds(JobFacts facts);

    /** So many events of a type; at least one where no number is given. */
    record HasEvent(String type, OptionalInt count) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            int found = facts.structure().events(type).size();
            return count.isPresent() ? found == count.getAsInt() : found > 0;
        }
    }

    /** A vertex with events of both types. */
    record EventWith(String type, String with) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().haveBoth(type, with);
        }
    }

    /**
     * A field of every event of a type, of which there is one at least.
     *
     * @param from {@code value}, {@code variable}, {@code task}, {@code ask}, {@code none}; empty text: from anywhere
     * @param is its value
     * @param variable the name of its variable; empty text: any
     */
    record FieldFrom(String type, String field, String from, Optional<JsonNode> is, String variable)
            implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            List<PlanStructure.Event> events = facts.structure().events(type);
            return !events.isEmpty()
                    && events.stream().allMatch(event -> facts.structure().comes(event, field, from, is, variable));
        }
    }

    /** What a field of one event is written to is what a field of every other event is read from. */
    record WrittenAndRead(String writer, String written, String reader, String read) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            List<PlanStructure.Event> readers = facts.structure().events(reader);
            return !readers.isEmpty()
                    && readers.stream()
                            .allMatch(event -> facts.structure()
                                    .variableRead(event, read)
                                    .filter(facts.structure().variablesWritten(writer, written)::contains)
                                    .isPresent());
        }
    }

    /** A markup on every event of a type, of which there is one at least. */
    record HasMarkup(String event, String type, Map<String, JsonNode> options) implements JobPredicate {
        public HasMarkup {
            options = Collections.unmodifiableMap(new LinkedHashMap<>(options));
        }

        @Override
        public boolean holds(JobFacts facts) {
            List<PlanStructure.Event> events = facts.structure().events(event);
            return !events.isEmpty()
                    && events.stream().allMatch(one -> facts.structure().hasMarkup(one, type, options));
        }
    }

    /** An edge between two kinds of vertices, with such a requirement unless none is named. */
    record EdgeRequires(String from, String to, Map<String, JsonNode> requirement) implements JobPredicate {
        public EdgeRequires {
            requirement = Collections.unmodifiableMap(new LinkedHashMap<>(requirement));
        }

        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().edgeRequires(from, to, requirement);
        }
    }

    /** An edge into a transition without input events with such a requirement. */
    record SilentEdge(Map<String, JsonNode> requirement) implements JobPredicate {
        public SilentEdge {
            requirement = Collections.unmodifiableMap(new LinkedHashMap<>(requirement));
        }

        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().silentEdgeRequires(requirement);
        }
    }

    /** A way from one kind of vertex to another, through a third unless that is empty text. */
    record HasPath(String from, String to, String through) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().leads(from, to, through);
        }
    }

    /** A start place, or none. */
    record HasStart(boolean has) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().plan().startPlace().isPresent() == has;
        }
    }

    /** So many end places. */
    record EndPlaces(int count) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().plan().places().stream()
                            .filter(place -> place.end())
                            .count()
                    == count;
        }
    }

    /** At least so many places, or transitions. */
    record VertexCount(int count, boolean isPlaces) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            Plan plan = facts.structure().plan();
            return count
                    <= (isPlaces ? plan.places().size() : plan.transitions().size());
        }
    }

    /** Each transition has one in place and one out place; or it is not so. */
    record IsStraight(boolean is) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            Plan plan = facts.structure().plan();
            return is
                    == plan.transitions().stream()
                            .allMatch(t -> plan.inEdgesOf(t.id()).size() == 1
                                    && plan.outEdgesOf(t.id()).size() == 1);
        }
    }

    /** An interrupt of a name. */
    record HasInterrupt(String name) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().interrupts().stream().anyMatch(name::equalsIgnoreCase);
        }
    }

    /** A sub-mission of a plan. */
    record Runs(String plan) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.structure().runs(plan);
        }
    }

    /** The checks find something. */
    record HasFinding(String code) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return facts.findings().stream().anyMatch(finding -> finding.code().equals(code));
        }
    }

    /** How a hidden case went. */
    record CaseWent(String name, CaseEnd how) implements JobPredicate {
        public CaseWent {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(how, "how");
        }

        @Override
        public boolean holds(JobFacts facts) {
            return facts.outcome(name).filter(outcome -> outcome.went(how)).isPresent();
        }
    }

    /** Not so. */
    record Not(JobPredicate predicate) implements JobPredicate {
        @Override
        public boolean holds(JobFacts facts) {
            return !predicate.holds(facts);
        }
    }

    /** One of them at least. */
    record AnyOf(List<JobPredicate> predicates) implements JobPredicate {
        public AnyOf {
            predicates = List.copyOf(predicates);
        }

        @Override
        public boolean holds(JobFacts facts) {
            return predicates.stream().anyMatch(one -> one.holds(facts));
        }
    }
}

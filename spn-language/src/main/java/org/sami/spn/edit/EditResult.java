package org.sami.spn.edit;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** What came of an edit. */
public sealed interface EditResult {
    /** The project after the edit; empty where it was refused. */
    Optional<Project> project();

    /**
     * The edit was made.
     *
     * @param changed the project after it
     * @param touched ids of the plans that were changed, added or removed; plans that are not named are the same objects as before
     * @param remarks sentences for the author about parts that were removed along with others, or still refer to removed ones
     */
    record Done(Project changed, Set<String> touched, List<String> remarks) implements EditResult {
        public Done {
            Objects.requireNonNull(changed, "changed");
            touched = Collections.unmodifiableSet(new LinkedHashSet<>(touched));
            remarks = List.copyOf(remarks);
        }

        static Done of(Project before, Project after, List<String> remarks) {
            IdentityHashMap<Plan, Boolean> same = new IdentityHashMap<>();
            before.plans().forEach(p -> same.put(p, Boolean.TRUE));
            Set<String> touched = new LinkedHashSet<>();
            after.plans().stream().filter(p -> same.remove(p) == null).forEach(p -> touched.add(p.id()));
            same.keySet().stream().map(Plan::id).sorted().forEach(touched::add);
            return new Done(after, touched, remarks);
        }

        @Override
        public Optional<Project> project() {
            return Optional.of(changed);
        }
    }

    /**
     * The edit is not possible, and nothing was changed.
     *
     * @param message one sentence on what is in the way and where
     */
    record Refused(String message) implements EditResult {
        public Refused {
            Objects.requireNonNull(message, "message");
        }

        @Override
        public Optional<Project> project() {
            return Optional.empty();
        }
    }
}

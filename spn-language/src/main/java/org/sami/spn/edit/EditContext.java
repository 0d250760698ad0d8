package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** The context in which edits are applied: the domain's vocabulary, and the list of parts that were removed along. */
public final class EditContext {
    private final Vocabulary vocabulary;
    private final List<String> remarks = new ArrayList<>();

    EditContext(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** The words of the domain. */
    public Vocabulary vocabulary() {
        return vocabulary;
    }

    /** Tells the author, in one sentence, what went along or still speaks of what is gone. */
    public void tell(String sentence) {
        remarks.add(sentence);
    }

    List<String> remarks() {
        return remarks;
    }

    /** Removes parts that refer to removed ones, keeps plans that are equal to what they were, and refuses what is not well-formed. */
    Project settle(Project before, Project changed) throws EditRefusedException {
        Map<String, Plan> old = new LinkedHashMap<>();
        before.plans().forEach(p -> old.putIfAbsent(p.id(), p));
        boolean globals = !before.globals().equals(changed.globals()); // test cases of every plan may speak of them
        List<Plan> plans = new ArrayList<>();
        for (Plan plan : changed.plans()) {
            plans.add(settled(old.get(plan.id()), plan, changed, globals));
        }
        Project settled = changed.withPlans(plans);
        for (String problem : new WellFormed(vocabulary).newProblems(before, settled)) {
            throw new EditRefusedException(problem);
        }
        return settled;
    }

    @SuppressWarnings("ReferenceEquality") // the same object needs no look; an equal one is replaced by the old
    private Plan settled(@Nullable Plan old, Plan plan, Project project, boolean globals) {
        if (plan == old && !globals) {
            return plan;
        }
        Plan settled = new Leftovers(plan, project, vocabulary, this::tell).removed();
        return old != null && settled.equals(old) ? old : settled;
    }
}

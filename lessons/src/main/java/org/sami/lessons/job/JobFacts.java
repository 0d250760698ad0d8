package org.sami.lessons.job;

import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Finding;

/** What predicates are asked of: a plan, what the checks find in it, and how the hidden cases go with it. */
interface JobFacts {
    PlanStructure structure();

    List<Finding> findings();

    /** How the case of a name went; empty where there is no such case, or the plan cannot be run. */
    Optional<CaseOutcome> outcome(String name);
}

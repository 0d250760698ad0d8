package org.sami.spn.analysis;

import java.util.function.Consumer;
import org.sami.spn.finding.Finding;

/** One check of one plan. Implementations have no state. */
interface PlanCheck {
    /** Reports what this check finds in a plan. */
    void check(PlanContext plan, Consumer<Finding> report);
}

package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;

/** One check of one plan. Implementations have no state. */
interface PlanCheck {
    /** Reports what this check finds in a plan. */
    void check(PlanContext plan, Consumer<Finding> report);

    /** Why each of its findings matters and how it is mended: one for each code that it reports. */
    List<Advice> advice();
}

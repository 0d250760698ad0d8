package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;

/** Which sub-missions of the library's plans nets follow (docs/analysis.md). */
class FollowedSubMissionsTest {
    /** Its boats may stand in one place twice. */
    private static final String COPYING = "deploy-and-station-keep";

    private final Set<String> followed = new TreeSet<>();
    private final Set<String> open = new TreeSet<>();

    private void translate(int boats, Predicate<Plan> which) throws PlanNetTooLargeException {
        for (Map.Entry<Project, Plan> each : TriedPlans.library().toList()) {
            Plan plan = each.getValue();
            if (!which.test(plan)) {
                continue;
            }
            PlanNet net = PlanNet.of(new PlanNetRequest(
                            each.getKey(), TriedPlans.LIBRARY.vocabulary(), plan.id(), TriedPlans.robots(boats))
                    .toDepth(1));
            for (Place place : plan.places()) {
                if (!place.subMissions().isEmpty()) {
                    boolean isFollowed = !net.isOpen(net.net().initialMarking(), place.id());
                    (isFollowed ? followed : open).add(plan.id() + "/" + place.id());
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void allAreFollowed(int boats) throws PlanNetTooLargeException {
        translate(boats, plan -> true);

        assertThat(followed)
                .containsExactly(
                        "clv-dangerous-area/traverse",
                        "clv-interrupts/assemble",
                        "clv-interrupts/recharge",
                        "clv-reassign/recharge",
                        COPYING + "/station",
                        "explore-team/avoid",
                        "explore-team/swap");
        assertThat(open).isEmpty();
    }

    @Test
    void thatOfThePlanThatCopiesBoatsIsFollowedWithFive() throws PlanNetTooLargeException {
        translate(5, plan -> plan.id().equals(COPYING));

        assertThat(followed).containsExactly(COPYING + "/station");
    }
}

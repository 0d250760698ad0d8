package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
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
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 5})
    void allAreFollowed(int boats) throws PlanNetTooLargeException {
        Set<String> followed = new TreeSet<>();
        Set<String> open = new TreeSet<>();
        for (Map.Entry<Project, Plan> each : TriedPlans.library().toList()) {
            Plan plan = each.getValue();
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

        assertThat(followed)
                .containsExactly(
                        "clv-dangerous-area/traverse",
                        "clv-interrupts/assemble",
                        "clv-interrupts/recharge",
                        "clv-reassign/recharge",
                        "deploy-and-station-keep/station",
                        "explore-team/avoid",
                        "explore-team/swap");
        assertThat(open).isEmpty();
    }
}

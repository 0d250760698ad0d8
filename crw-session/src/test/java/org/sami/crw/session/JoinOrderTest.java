package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class JoinOrderTest {
    private final JoinOrder order = new JoinOrder();

    @Test
    void boatsThatAreThereWhenTheFirstMissionStartsStandByNameInWhicheverOrderTheyJoined() {
        order.join(List.of("carl"));
        order.join(List.of("anna", "bert"));
        assertThat(order.decided()).isEmpty();

        order.begin();

        assertThat(order.decided()).containsExactly("anna", "bert", "carl");
    }

    @Test
    void laterBoatsStandBehindInTheOrderInWhichTheyJoined() {
        order.join(List.of("bert"));
        order.begin();
        order.join(List.of("dora"));
        order.join(List.of("anna"));
        order.begin();

        assertThat(order.decided()).containsExactly("bert", "dora", "anna");
        assertThat(order.indexOf("dora")).isOne();
        assertThat(order.indexOf("nobody")).isEqualTo(3);
    }
}

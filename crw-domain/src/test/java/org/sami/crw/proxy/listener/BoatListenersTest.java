package org.sami.crw.proxy.listener;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.command.BoatCommand;

class BoatListenersTest {

    @Test
    void everyKindOfNewsReachesEveryListenerInOrder() throws Exception {
        List<String> heard = new ArrayList<>();
        BoatListener both = new BoatListeners(recorder("first", heard), recorder("second", heard));
        List<String> expected = new ArrayList<>();
        for (Method method : BoatListener.class.getMethods()) {
            method.invoke(both, nothing(method));
            expected.add("first " + method.getName());
            expected.add("second " + method.getName());
        }

        assertThat(heard).isEqualTo(expected).hasSizeGreaterThan(20);
    }

    @Test
    void whatOneListenerThrowsIsToldAndDoesNotSilenceTheNext() {
        List<String> heard = new ArrayList<>();
        BoatListener failing = new BoatListener() {
            @Override
            public void onCompleted(String boatId, BoatCommand command) {
                throw new IllegalStateException("spilled");
            }

            @Override
            public void onListenerFault(String listener, Throwable fault) {
                throw new IllegalStateException("again");
            }
        };
        BoatListener next = new BoatListener() {
            @Override
            public void onCompleted(String boatId, BoatCommand command) {
                heard.add("completed " + boatId);
            }

            @Override
            public void onListenerFault(String listener, Throwable fault) {
                heard.add(listener + " threw " + fault.getMessage());
            }
        };

        new BoatListeners(failing, next).onCompleted("boat1", null);

        assertThat(heard).containsExactly("completed boat1", failing.getClass().getName() + " threw spilled");
    }

    @Test
    void aFaultInsideIsToldOnce() {
        List<String> heard = new ArrayList<>();
        BoatListener failing = new BoatListener() {
            @Override
            public void onTakenOver(String boatId) {
                throw new AssertionError("spilled");
            }
        };

        new BoatListeners(new BoatListeners(failing, recorder("inner", heard)), recorder("outer", heard))
                .onTakenOver("boat1");

        assertThat(heard).containsExactly("inner onTakenOver", "inner onListenerFault", "outer onTakenOver");
    }

    private static Object[] nothing(Method method) {
        return Arrays.stream(method.getParameterTypes())
                .map(type -> type == boolean.class ? (Object) true : type == int.class ? (Object) 0 : null)
                .toArray();
    }

    private static BoatListener recorder(String name, List<String> heard) {
        return (BoatListener) Proxy.newProxyInstance(
                BoatListener.class.getClassLoader(), new Class<?>[] {BoatListener.class}, (self, method, args) -> {
                    heard.add(name + " " + method.getName());
                    return null;
                });
    }
}

#include "gvd/diagram.hpp"
